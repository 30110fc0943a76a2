using System;

namespace UnityEngine
{
    [AttributeUsage(AttributeTargets.Field, AllowMultiple = true)]
    public class HeaderAttribute(string header) : PropertyAttribute
    {
        public readonly string header = header;
    }

    [AttributeUsage(AttributeTargets.Field, AllowMultiple = true)]
    public class SpaceAttribute(float height) : PropertyAttribute
    {
        public readonly float height = height;

        public SpaceAttribute() : this(8f)
        {
        }
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class TextAreaAttribute(int minLines, int maxLines) : PropertyAttribute
    {
        public readonly int minLines = minLines;
        public readonly int maxLines = maxLines;

        public TextAreaAttribute() : this(3, 3)
        {
        }
    }

    [AttributeUsage(AttributeTargets.Field, AllowMultiple = true)]
    public class ContextMenuItemAttribute(string name, string function) : PropertyAttribute
    {
        public readonly string name = name;
        public readonly string function = function;
    }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class NonReorderableAttribute : PropertyAttribute;

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class SerializeReference : Attribute;

    public interface ISerializationCallbackReceiver
    {
        void OnBeforeSerialize();
        void OnAfterDeserialize();
    }
}

namespace UnityEngine.Serialization
{
    [AttributeUsage(AttributeTargets.Field, AllowMultiple = true, Inherited = false)]
    public class FormerlySerializedAsAttribute(string oldName) : Attribute
    {
        public string oldName { get; } = oldName;
    }
}

namespace UnityEngine.Scripting.APIUpdating
{
    [AttributeUsage(
        AttributeTargets.Class | AttributeTargets.Struct | AttributeTargets.Enum | AttributeTargets.Interface | AttributeTargets.Delegate)]
    public class MovedFromAttribute : Attribute
    {
        public MovedFromAttribute(
            bool autoUpdateAPI, string sourceNamespace = null, string sourceAssembly = null, string sourceClassName = null)
        {
        }
    }
}
