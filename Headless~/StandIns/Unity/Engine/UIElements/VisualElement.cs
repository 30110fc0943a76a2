namespace UnityEngine.UIElements;

public abstract class CallbackEventHandler
{
}

public abstract class Focusable : CallbackEventHandler
{
}

public class VisualElement : Focusable
{
}
