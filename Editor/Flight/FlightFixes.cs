using System;
using Alate.Catalogue;
using Alate.Flight;
using Alate.Wake;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Remedies for flights, each undoable in one step.</summary>
    internal static class FlightFixes
    {
        /// <summary>Bakes trims of a model, and tells each line of what it does; null where nothing closes, with what is missing.</summary>
        public delegate TrimTable Bake(FlightModel model, Action<string> tell, out string missing);

        /// <summary>Adds a pilot that flies the erratic track of a butterfly about where the insect starts.</summary>
        public static FixOutcome AddPilot(InsectFlight flight)
        {
            Undo.AddComponent<WanderPilot>(flight.gameObject).StayAroundStart();
            return FixOutcome.Done();
        }

        /// <summary>Gives an insect the parts of a monarch's body, at the size of its wings.</summary>
        public static FixOutcome TakeBody(InsectFlight flight)
        {
            InsectDefinition monarch = InsectCatalogue.Find("monarch");
            InsectWings wings = flight.GetComponent<InsectWings>();
            float scale = new PresetValues(wings.Preset).size.wingLength / monarch.Wings[0].PresetLength(InsectVariant.Flight);
            Edits.Change(flight, "Take A Monarch's Body", changed =>
            {
                changed.Parts.Clear();
                foreach (BodyEllipsoid part in monarch.FlightParts)
                    changed.Parts.Add(part.Scaled(scale));
            });
            return FixOutcome.Done();
        }

        /// <summary>Bakes trims for an insect as it is set up, saves them as an asset and assigns it.</summary>
        /// <param name="flight">The insect.</param>
        /// <param name="bake">How trims are baked.</param>
        /// <param name="ask">Where to save them.</param>
        public static FixOutcome BakeTrims(InsectFlight flight, Bake bake, AskForPath ask)
        {
            string path = ask("Save Flight Trims", AssetPath.FileName(flight.name + " Flight Trims"),
                "Choose where the trims are saved. Baking takes about a minute.");
            if (string.IsNullOrEmpty(path))
                return FixOutcome.Refused("");
            string obstacle = AssetPath.FindProblem(path);
            if (obstacle != null)
                return FixOutcome.Refused(obstacle);
            try
            {
                using FlightModel model = flight.CreateModel();
                using TrimTable table = bake(model, line => Debug.Log($"'{flight.name}': {line}", flight), out string missing);
                if (table == null)
                    return FixOutcome.Refused("No steady flight was found. " + missing);
                FlightTrims saved = AssetWriter.Save(FlightTrims.Create(table, model), path, "Bake Trims");
                Edits.Change(flight, "Bake Trims", changed => changed.Trims = saved);
                return FixOutcome.Done(missing == null ? "" : "Some steady flights are left out: " + missing);
            }
            catch (InvalidOperationException problem)
            {
                return FixOutcome.Refused(problem.Message);
            }
        }

        /// <summary>Bakes trims over the default speeds and climbs, with a bar that tells how far it is and can be cancelled.</summary>
        public static TrimTable BakeWithBar(FlightModel model, Action<string> tell, out string missing)
        {
            int points = TrimBake.DefaultSpeeds.Count * TrimBake.DefaultClimbs.Count, told = 0;
            var bake = new TrimBake(model)
            {
                Wake = new TrimWake(),
                Log = line =>
                {
                    tell(line);
                    if (EditorUtility.DisplayCancelableProgressBar("Bake Trims", line, Mathf.Clamp01((float)++told / points)))
                        throw new InvalidOperationException("Cancelled.");
                },
            };
            try
            {
                EditorUtility.DisplayProgressBar("Bake Trims", "Looking for steady flights", 0f);
                TrimTable table = bake.Bake();
                missing = bake.Problem;
                return table;
            }
            finally
            {
                EditorUtility.ClearProgressBar();
            }
        }
    }
}
