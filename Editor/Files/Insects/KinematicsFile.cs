using System.Collections.Generic;
using System.Linq;

namespace Alate.Files
{
    /// <summary>Kinematics that a file prescribes: the motion of some or all wings of an insect.</summary>
    internal sealed class KinematicsFile
    {
        /// <summary>Name that stands for every wing.</summary>
        public const string AllWings = "all";

        /// <param name="name">What it is called; null for none.</param>
        /// <param name="source">Where it was published; null for none.</param>
        /// <param name="wings">The motion of each wing that the file names; "all" is every wing.</param>
        public KinematicsFile(string name, string source, IReadOnlyDictionary<string, PresetKinematics> wings)
        {
            Name = name;
            Source = source;
            Wings = wings;
        }

        /// <summary>Title of the motion; null for none.</summary>
        public string Name { get; }

        /// <summary>Publication; null for none.</summary>
        public string Source { get; }

        /// <summary>The motion of each wing that the file names.</summary>
        public IReadOnlyDictionary<string, PresetKinematics> Wings { get; }

        /// <summary>Hertz, of all wings.</summary>
        public float Frequency => Wings.First().Value.frequency;

        /// <summary>Reads a file for the wings of an insect.</summary>
        /// <param name="path">The file.</param>
        /// <param name="names">Names of the insect's wings.</param>
        /// <param name="files">Reads it.</param>
        /// <exception cref="UserException">It is no such file, or it names a wing that the insect does not have.</exception>
        public static KinematicsFile Read(string path, IReadOnlyList<string> names, FileSource files)
        {
            KinematicsFile file = files.ReadText(path, KinematicsJson.Read);
            string stranger = file.Wings.Keys.FirstOrDefault(name => name != AllWings && !names.Contains(name));
            return stranger == null
                ? file
                : throw new UserException($"{path}: wings.{stranger}: the insect has no such wing. It has: "
                    + $"{string.Join(", ", names)}; 'all' is every wing.");
        }

        /// <summary>Prescribes the motion of a wing; one that is not named beats as its species does, at the file's frequency.</summary>
        /// <param name="name">The wing's name.</param>
        /// <param name="preset">Its numbers.</param>
        public void ApplyTo(string name, WingPreset preset)
        {
            if (Wings.TryGetValue(name, out PresetKinematics motion) || Wings.TryGetValue(AllWings, out motion))
            {
                preset.Kinematics = motion;
                return;
            }

            preset.Beat.maxFrequency = Frequency;
            preset.Beat.frequencyFloor = 1f;
        }
    }
}
