namespace Alate.Cli;

/// <summary>Kinematics that a file prescribes: the motion of some or all wings of an insect.</summary>
/// <param name="Name">What it is called; null for none.</param>
/// <param name="Source">Where it was published; null for none.</param>
/// <param name="Wings">The motion of each wing that the file names; "all" is every wing.</param>
internal sealed record KinematicsFile(string Name, string Source, IReadOnlyDictionary<string, PresetKinematics> Wings)
{
    /// <summary>Name that stands for every wing.</summary>
    public const string AllWings = "all";

    /// <summary>Hertz, of all wings.</summary>
    public float Frequency => Wings.First().Value.frequency;

    /// <summary>
    /// Prescribes the motion of an insect's wings; a wing that is not named beats as its species does, at the file's frequency.
    /// </summary>
    /// <param name="path">The file, for messages.</param>
    /// <param name="wings">The insect's wings.</param>
    /// <exception cref="UserException">The file names a wing that the insect does not have.</exception>
    public void ApplyTo(string path, IReadOnlyList<InsectWing> wings)
    {
        string stranger = Wings.Keys.FirstOrDefault(name => name != AllWings && wings.All(wing => wing.Name != name));
        if (stranger != null)
        {
            throw new UserException($"{path}: wings.{stranger}: the insect has no such wing. It has: "
                + $"{string.Join(", ", wings.Select(wing => wing.Name))}; 'all' is every wing.");
        }
        foreach (InsectWing wing in wings)
        {
            if (Wings.TryGetValue(wing.Name, out PresetKinematics motion) || Wings.TryGetValue(AllWings, out motion))
            {
                wing.Preset.Kinematics = motion;
                continue;
            }

            wing.Preset.Beat.maxFrequency = Frequency;
            wing.Preset.Beat.frequencyFloor = 1f;
        }
    }
}
