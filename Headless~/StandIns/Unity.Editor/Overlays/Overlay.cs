using UnityEngine.UIElements;

namespace UnityEditor.Overlays;

public abstract class Overlay
{
    protected Overlay()
    {
    }

    public string id { get; }
    public string displayName { get; set; }
    public bool displayed { get; set; }
    public bool collapsed { get; set; }
    public EditorWindow containerWindow { get; }

    public abstract VisualElement CreatePanelContent();

    public virtual void OnCreated()
    {
    }

    public virtual void OnWillBeDestroyed()
    {
    }
}
