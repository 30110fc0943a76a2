using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Templates, shared by insects with equal mesh, wings and skeletons. Unused ones are kept for a while: a pool takes its insects back.
    /// </summary>
    internal sealed class TemplateCache : IDisposable
    {
        private readonly List<(TemplateKey key, MeshTemplate template)> m_Entries = new List<(TemplateKey, MeshTemplate)>();

        /// <summary>Finds or builds the template for some wings of one mesh, and adds one user.</summary>
        /// <param name="key">What it is made of.</param>
        /// <param name="parts">How to make what is not there.</param>
        /// <param name="wings">The wings on it.</param>
        /// <param name="indices">Their places in the insect's list, for messages.</param>
        /// <param name="problem">Why there is none.</param>
        /// <returns>Null when there is a problem.</returns>
        public MeshTemplate Acquire(TemplateKey key, in RiggedParts parts, Wing[] wings, List<int> indices, out InsectProblem problem)
        {
            problem = InsectProblem.None;
            MeshTemplate template = m_Entries.Find(entry => !entry.template.IsOutdated && entry.key.Matches(key)).template;
            if (template != null)
            {
                template.Users++;
                return template;
            }

            RiggedPart[] shapes = parts.Build(wings, indices, out problem);
            if (shapes == null)
                return null;
            try
            {
                template = new MeshTemplate(parts.Mesh, shapes);
            }
            catch
            {
                foreach (RiggedPart shape in shapes)
                    shape.Rig.Release();
                throw;
            }

            template.Users = 1;
            m_Entries.Add((key, template));
            return template;
        }

        /// <summary>Removes one user.</summary>
        public void Return(MeshTemplate template)
        {
            template.Users--;
            template.UnusedSince = Time.realtimeSinceStartupAsDouble;
            FreeUnused();
        }

        /// <summary>Frees templates that were unused for some time.</summary>
        public void FreeUnused()
        {
            double now = Time.realtimeSinceStartupAsDouble;
            for (int k = m_Entries.Count - 1; k >= 0; k--)
            {
                MeshTemplate template = m_Entries[k].template;
                if (template.Users == 0 && (template.IsOutdated || now - template.UnusedSince >= WingSystem.Patience))
                    Free(k);
            }
        }

        /// <summary>Frees all templates.</summary>
        public void Dispose()
        {
            while (m_Entries.Count > 0)
                Free(m_Entries.Count - 1);
        }

        private void Free(int index)
        {
            m_Entries[index].template.Destroy();
            m_Entries.RemoveAt(index);
        }
    }
}
