namespace Alate.Files
{
    /// <summary>Kinds of values of a JSON file.</summary>
    internal enum JsonKind
    {
        Object,
        List,
        Text,
        Number,
        True,
        False,
        Null,
    }
}
