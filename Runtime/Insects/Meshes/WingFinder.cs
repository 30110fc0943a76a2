using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Finds the wings under an object: by the names of objects, meshes and materials, else by their symmetry.</summary>
    public static class WingFinder
    {
        // Area over that of the largest named part from which a named part is a wing, not a screw called "wing".
        private const float k_SmallestNamed = 0.05f;

        /// <summary>Finds the wings that plain renderers draw, ordered fore right, fore left, hind right, hind left.</summary>
        /// <remarks>
        /// Names go first: an object, mesh or material called wing or fin, in English, but no elytra or wing covers. Where none is, thin
        /// parts count that are mirrored in the plane x = 0 of the object, the two largest pairs at most. The side is where most of a wing
        /// is (+X is right); the pair is named, or else the one further along +Z is the fore wing. Of levels of detail only the highest
        /// counts. Hidden children count where no shown ones are wings. Of meshes that are not readable, names and bounds have to tell.
        /// </remarks>
        /// <param name="root">The insect: X right, Y up, Z ahead.</param>
        /// <returns>New wings without skeletons; empty if nothing looks like one.</returns>
        /// <exception cref="ArgumentNullException">There is no object.</exception>
        public static List<Wing> Find(Transform root)
        {
            if (root == null)
                throw new ArgumentNullException(nameof(root));
            List<WingCandidate> wings = Choose(DrawnRenderers.Under(root, false), root);
            if (wings.Count == 0)
                wings = Choose(DrawnRenderers.Under(root, true), root);
            WingPairing.Assign(wings);
            wings.Sort(WingPairing.Compare);
            return wings.ConvertAll(candidate => candidate.ToWing());
        }

        /// <summary>
        /// The skinned renderers that draw wings, alone or with the body; <see cref="SkinnedWingConversion"/> makes plain ones of them.
        /// </summary>
        /// <remarks>Bones that are called wing count too. Hidden renderers do not.</remarks>
        /// <param name="root">The insect: X right, Y up, Z ahead.</param>
        /// <exception cref="ArgumentNullException">There is no object.</exception>
        public static List<SkinnedMeshRenderer> FindSkinned(Transform root)
        {
            if (root == null)
                throw new ArgumentNullException(nameof(root));
            var found = new List<SkinnedMeshRenderer>();
            foreach (Renderer renderer in DrawnRenderers.Under(root, false))
            {
                if (renderer is SkinnedMeshRenderer skinned && SkinnedWings.IsIn(skinned, root))
                    found.Add(skinned);
            }

            return found;
        }

        private static List<WingCandidate> Choose(List<Renderer> renderers, Transform root)
        {
            var candidates = new List<WingCandidate>();
            foreach (Renderer renderer in renderers)
            {
                if (renderer is MeshRenderer)
                    candidates.AddRange(WingCandidates.Of(renderer, DrawnRenderers.MeshOf(renderer), root));
            }

            List<WingCandidate> named = candidates.FindAll(candidate => candidate.isNamed);
            if (named.Count == 0)
                return MirrorPairs.Of(candidates);
            float largest = 0f;
            named.ForEach(candidate => largest = Mathf.Max(largest, candidate.shape.area));
            return named.FindAll(candidate => candidate.shape.area >= k_SmallestNamed * largest);
        }
    }
}
