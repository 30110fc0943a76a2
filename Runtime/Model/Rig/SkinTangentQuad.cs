using Unity.Mathematics;

namespace Alate
{
    /// <summary>Rest tangents of the four vertices of a <see cref="SkinQuad"/>, mesh space; w is Unity's sign of the bitangent.</summary>
    internal struct SkinTangentQuad
    {
        public float4 tx;
        public float4 ty;
        public float4 tz;
        public float4 tw;
    }
}
