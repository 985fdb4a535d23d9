/** Generated shaders, from the folder of the Python package. */
declare module "@shaders/wgsl/*.wgsl?raw" {
  const text: string;
  export default text;
}
declare module "@shaders/bake.json" {
  const content: unknown;
  export default content;
}
declare module "*.wgsl?raw" {
  const text: string;
  export default text;
}
