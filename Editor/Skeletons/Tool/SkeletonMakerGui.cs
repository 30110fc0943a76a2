using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>Offers skeletons for wings of the selected insects that have none.</summary>
    internal static class SkeletonMakerGui
    {
        public static void Draw()
        {
            foreach (GameObject chosen in Selection.gameObjects)
            {
                if (!chosen.TryGetComponent(out InsectWings insect))
                    continue;
                List<Wing> bare = InsectTargets.WithoutSkeleton(insect);
                if (bare.Count > 0 && GUILayout.Button($"Make {bare.Count} skeletons for '{insect.name}'"))
                    Make(insect, bare);
            }
        }

        private static void Make(InsectWings insect, List<Wing> bare)
        {
            foreach (Wing wing in bare)
            {
                WingSkeleton made = null;
                try
                {
                    made = new AutomaticSkeleton(insect.transform, wing.Renderer.transform).Fit(InsectTargets.SurfaceOf(wing, out _));
                }
                catch (ArgumentException refused)
                {
                    Debug.LogWarning(refused.Message, insect);
                    continue;
                }

                made.name = $"{insect.name} {wing.Renderer.name}";
                if (!SkeletonFiles.Save(made, null))
                {
                    Object.DestroyImmediate(made);
                    continue;
                }

                Undo.RecordObject(insect, "Make Wing Skeleton");
                wing.Skeleton = made;
                EditorUtility.SetDirty(insect);
            }
        }
    }
}
