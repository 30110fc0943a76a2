using System.Collections.Generic;
using Alate.Catalogue;

namespace Alate.Proof
{
    /// <summary>Scenes whose tracks are compared: the same code makes the golden file and is run where they are proved.</summary>
    internal static class GoldenScenes
    {
        private static readonly string[] s_Fliers = { "monarch", "dragonfly" };

        /// <summary>Runs all scenes: wings of all insects on the spot, two free flights, a frame of a crowd.</summary>
        public static List<GoldenTrack> Run()
        {
            var tracks = new List<GoldenTrack>();
            foreach (InsectDefinition insect in InsectCatalogue.All)
            {
                using (var scene = new TetheredGolden(insect))
                    tracks.AddRange(scene.Run());
            }

            foreach (string name in s_Fliers)
            {
                using (var scene = new FreeGolden(InsectCatalogue.Find(name)))
                    tracks.Add(scene.Run());
            }

            using (var scene = new CrowdGolden())
                tracks.Add(scene.Run());
            return tracks;
        }
    }
}
