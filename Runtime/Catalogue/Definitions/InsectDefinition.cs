using System.Collections.Generic;
using System.Linq;
using Alate.Flight;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>A species of the catalogue: its wings, its body, and where its numbers come from.</summary>
    [MovedFrom(true, "Alate", "Alate", "SpeciesDefinition")]
    public sealed class InsectDefinition
    {
        /// <summary>
        /// Mesh units of one metre of the real insect: ten times life size, so that a monarch spans more than a unit and even a firefly
        /// lies beyond a camera's near plane. The model takes its lengths from <see cref="PresetSize"/>; this number and any scale of a
        /// transform change the picture only.
        /// </summary>
        public const float UnitsPerMetre = 10f;

        internal InsectDefinition(
            string name, string displayName, IReadOnlyList<WingDefinition> wings, InsectBody body, IReadOnlyList<InsectSource> sources)
        {
            Name = name;
            DisplayName = displayName;
            Wings = wings;
            Body = body;
            Sources = sources;
        }

        /// <summary>Name for look-ups: lower case, words joined by hyphens.</summary>
        public string Name { get; }

        /// <summary>Display name.</summary>
        public string DisplayName { get; }

        /// <summary>The kinds of wings, from front to back; each comes as a right and a left one.</summary>
        public IReadOnlyList<WingDefinition> Wings { get; }

        /// <summary>The body.</summary>
        public InsectBody Body { get; }

        /// <summary>Parts of the body as the flight sees them, from the middle of the thorax.</summary>
        public IReadOnlyList<BodyEllipsoid> FlightParts { get; internal set; } = System.Array.Empty<BodyEllipsoid>();

        /// <summary>Part of the body that swings with the beat, the abdomen; its swing is 0 where none does.</summary>
        internal BodyEllipsoid Abdomen => FlightParts.FirstOrDefault(part => part.swing != 0f);

        /// <summary>Trim table of an insect that is not of the catalogue, as text; null for that of the catalogue.</summary>
        internal string Trims { get; set; }

        /// <summary>Path and text of the file that says the insect; null for one of the catalogue.</summary>
        internal string FilePath { get; set; }

        internal string FileText { get; set; }

        /// <summary>Sources of the numbers.</summary>
        public IReadOnlyList<InsectSource> Sources { get; }

        /// <summary>Variants of the species, the standard one first; all its wings have the same.</summary>
        public IReadOnlyList<InsectVariant> Variants => Wings[0].Variants;

        /// <summary>Triangles of all wings of both sides: the number of the paper's Table 2.</summary>
        public int TriangleCount => Wings.Sum(wing => 2 * wing.TriangleCount);
    }
}
