namespace UnityEditor;

public abstract class GUIDrawer;
