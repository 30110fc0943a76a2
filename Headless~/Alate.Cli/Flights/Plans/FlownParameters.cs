using System.Reflection;
using System.Runtime.CompilerServices;
using UnityEngine;

namespace Alate.Cli;

/// <summary>Every number that <c>sweep</c> knows, by the names of the inspector's sliders, and those of the flight.</summary>
internal static class FlownParameters
{
    private delegate ref T Group<T>(WingPreset preset);

    /// <summary>The numbers of a preset, in the inspector's order, as its fields have them.</summary>
    public static IReadOnlyList<FlownParameter> OfSpecies { get; } =
    [
        .. Fields<PresetSize>(preset => ref preset.Size),
        .. Fields<PresetBeat>(preset => ref preset.Beat),
        .. Fields<PresetWave>(preset => ref preset.Wave),
        .. Fields<PresetStiffness>(preset => ref preset.Stiffness),
    ];

    /// <summary>
    /// Everything: first elasticity as a factor on the species', as <c>fly</c> takes it, then the species' sliders, then the flight's
    /// numbers.
    /// </summary>
    public static IReadOnlyList<FlownParameter> All { get; } =
    [
        FlightNumbers.Elasticity.Swept(),
        .. OfSpecies.Where(parameter => parameter.Name != "elasticity"),
        FlightNumbers.Substeps.Swept("substeps-per-beat"),
        FlightNumbers.Speed.Swept(),
        FlightNumbers.Climb.Swept(),
        FlightNumbers.Pitch.Swept(),
        FlightNumbers.Wind.Swept(),
    ];

    /// <summary>Finds a number by its name; capitals, hyphens and underscores do not matter.</summary>
    /// <exception cref="UserException">There is none; the message lists those there are.</exception>
    public static FlownParameter Find(string name) =>
        All.FirstOrDefault(parameter => Plain(parameter.Name) == Plain(name))
        ?? throw new UserException(
            $"There is no parameter {Quote.Of(name)}. Known: {string.Join(", ", All.Select(parameter => parameter.Name))}.");

    // Every field of a group is a float.
    private static IEnumerable<FlownParameter> Fields<T>(Group<T> group) where T : struct =>
        typeof(T).GetFields(BindingFlags.Public | BindingFlags.Instance).OrderBy(field => field.MetadataToken).Select((field, k) =>
        {
            RangeAttribute range = field.GetCustomAttribute<UnityEngine.RangeAttribute>();
            UnitAttribute unit = field.GetCustomAttribute<UnitAttribute>();
            return new FlownParameter(
                Hyphenated(field.Name), unit.Unit, range?.min ?? unit.Min, range?.max ?? unit.Max,
                preset => ref Unsafe.Add(ref Unsafe.As<T, float>(ref group(preset)), k));
        });

    private static string Hyphenated(string name) =>
        string.Concat(name.Select(letter => char.IsUpper(letter) ? "-" + char.ToLowerInvariant(letter) : letter.ToString()));

    private static string Plain(string name) => string.Concat(name.Where(char.IsLetterOrDigit)).ToLowerInvariant();
}
