namespace UnityEditor.EditorTools;

public interface IDrawSelectedHandles
{
    void OnDrawHandles();
}
