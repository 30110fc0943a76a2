using System.Collections.Generic;

namespace Alate
{
    /// <summary>The templates in use; insects with the same mesh, wings and skeletons share one.</summary>
    internal sealed class TemplateCache
    {
        private readonly List<Entry> m_Entries = new List<Entry>();

        /// <summary>Templates in use.</summary>
        public int Count => m_Entries.Count;

        /// <summary>Finds or builds the template for some wings of one mesh; one user more.</summary>
        /// <param name="key">What it is made of.</param>
        /// <param name="parts">How to make what is not there.</param>
        /// <param name="wings">The wings on it.</param>
        /// <param name="indices">Their places in the insect's list, for messages.</param>
        /// <param name="problem">Why there is none.</param>
        /// <returns>Null when there is a problem.</returns>
        public MeshTemplate Take(TemplateKey key, in RiggedParts parts, Wing[] wings, List<int> indices, out InsectProblem problem)
        {
            problem = InsectProblem.None;
            foreach (Entry entry in m_Entries)
            {
                if (!entry.key.Matches(key))
                    continue;
                entry.template.Users++;
                return entry.template;
            }

            RiggedPart[] shapes = parts.Build(wings, indices, out problem);
            if (shapes == null)
                return null;
            MeshTemplate template = MeshTemplate.Build(parts.Mesh, shapes);
            template.Users = 1;
            m_Entries.Add(new Entry { key = key, template = template });
            return template;
        }

        /// <summary>One user fewer; the last one frees the template.</summary>
        public void Return(MeshTemplate template)
        {
            if (--template.Users > 0)
                return;
            m_Entries.RemoveAt(m_Entries.FindIndex(e => e.template == template));
            template.Destroy();
        }

        private struct Entry
        {
            public TemplateKey key;
            public MeshTemplate template;
        }
    }
}
