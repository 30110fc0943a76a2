using System.Reflection;
using System.Text.Json.Nodes;
using UnityEngine;

namespace Alate.Cli;

/// <summary>A key of a file that stands for one number or choice of a preset.</summary>
/// <param name="Name">With its unit in words.</param>
/// <param name="Shape">The value.</param>
/// <param name="Help">One or two sentences.</param>
/// <param name="Of">The value of a preset, as the file has it.</param>
/// <param name="Set">Gives a preset a checked value.</param>
internal sealed record PresetKey(
    string Name, FileShape Shape, string Help, Func<WingPreset, JsonNode> Of, Action<WingPreset, JsonPlace> Set)
    : FileKey(Name, Shape, Help)
{
    /// <summary>Reference to a group of a preset.</summary>
    public delegate ref T Group<T>(WingPreset preset) where T : struct;

    /// <summary>Units of presets, and those of files: the words behind a key, and how many make one of the preset's.</summary>
    private static readonly Dictionary<string, (string Suffix, string Words, decimal PerUnit)> s_Units = new()
    {
        [""] = ("", "", 1m),
        ["m"] = ("Millimetres", "millimetres", 1e3m),
        ["kg"] = ("Milligrams", "milligrams", 1e6m),
        ["kg/m³"] = ("KilogramsPerCubicMetre", "kilograms per cubic metre", 1m),
        ["Hz"] = ("Hertz", "hertz", 1m),
        ["m/s"] = ("MetresPerSecond", "metres per second", 1m),
        ["°"] = ("Degrees", "degrees", 1m),
        ["beats"] = ("Beats", "beats", 1m),
        ["half beats"] = ("HalfBeats", "half beats", 1m),
        ["chain lengths"] = ("ChainLengths", "chain lengths", 1m),
    };

    /// <summary>Keys of all fields of a group, in its order.</summary>
    public static IEnumerable<PresetKey> All<T>(Group<T> group) where T : struct =>
        typeof(T).GetFields(BindingFlags.Public | BindingFlags.Instance).OrderBy(field => field.MetadataToken)
            .Select(field => Field(group, field.Name));

    /// <summary>Key of a field.</summary>
    /// <param name="group">The struct that has it.</param>
    /// <param name="field">Its name there.</param>
    /// <param name="name">Its name in the file without the unit; null for that of the field.</param>
    /// <param name="help">Its help; null for the inspector's.</param>
    public static PresetKey Field<T>(Group<T> group, string field, string name = null, string help = null) where T : struct
    {
        FieldInfo found = typeof(T).GetField(field);
        help ??= found.GetCustomAttribute<TooltipAttribute>()?.tooltip ?? "";
        name ??= field;
        if (found.FieldType == typeof(float))
            return Number(group, found, name, help);
        if (found.FieldType == typeof(Vector3))
            return Place(group, found, name, help);
        if (found.FieldType == typeof(bool))
        {
            return new PresetKey(name, new ChoiceShape(), help, preset => (bool)Get(group, found, preset),
                (preset, value) => Put(group, found, preset, value.Text == "true"));
        }

        string[] words = Enum.GetNames(found.FieldType).Select(Camel).ToArray();
        return new PresetKey(name, new ChoiceShape(words), help, preset => Camel(Get(group, found, preset).ToString()),
            (preset, value) => Put(group, found, preset, Enum.GetValues(found.FieldType).GetValue(Array.IndexOf(words, value.Text))));
    }

    private static PresetKey Number<T>(Group<T> group, FieldInfo field, string name, string help) where T : struct
    {
        RangeAttribute range = field.GetCustomAttribute<RangeAttribute>();
        UnitAttribute unit = field.GetCustomAttribute<UnitAttribute>();
        // Angles of the rest have a range alone.
        (string suffix, string words, decimal perUnit) = s_Units[unit?.Unit ?? "°"];
        var shape = new NumberShape(
            FileNumber.ToFile(range?.min ?? unit.Min, perUnit), FileNumber.ToFile(range?.max ?? unit.Max, perUnit), words);
        return new PresetKey(
            name + suffix, shape, help, preset => FileNumber.Node((float)Get(group, field, preset), perUnit),
            (preset, value) => Put(group, field, preset, FileNumber.ToPreset(value.Text, perUnit)));
    }

    private static PresetKey Place<T>(Group<T> group, FieldInfo field, string name, string help) where T : struct => new(
        name + "Millimetres", FilePlace.Shape, help, preset => FilePlace.Node((Vector3)Get(group, field, preset)),
        (preset, value) => Put(group, field, preset, FilePlace.Read(value)));

    private static object Get<T>(Group<T> group, FieldInfo field, WingPreset preset) where T : struct => field.GetValue(group(preset));

    private static void Put<T>(Group<T> group, FieldInfo field, WingPreset preset, object value) where T : struct
    {
        object whole = group(preset);
        field.SetValue(whole, value);
        group(preset) = (T)whole;
    }

    private static string Camel(string name) => char.ToLowerInvariant(name[0]) + name[1..];
}
