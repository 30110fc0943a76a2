namespace UnityEngine.Rendering;

/// <summary>Drawing by a pipeline of one's own; none is ever active here.</summary>
public abstract class RenderPipelineAsset : ScriptableObject
{
    public virtual Shader defaultShader => null;
}
