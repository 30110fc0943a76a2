using UnityEngine.UIElements;

namespace UnityEditor.Overlays;

public abstract class IMGUIOverlay : Overlay
{
    protected IMGUIOverlay()
    {
    }

    public sealed override VisualElement CreatePanelContent() => throw Absent.Editor;

    public abstract void OnGUI();
}
