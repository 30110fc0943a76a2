namespace UnityEditor.Overlays;

public interface ITransientOverlay
{
    bool visible { get; }
}
