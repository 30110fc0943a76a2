using Alate.Catalogue;
using UnityEditor.AssetImporters;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>
    /// Parts and prefabs of an insect inside the asset of its file, each by an identifier that stays when the file changes, so that scenes
    /// keep what they refer to.
    /// </summary>
    internal sealed class ImportedInsect : InsectKeeper
    {
        private readonly AssetImportContext m_Context;
        private readonly bool m_Flies;
        private GameObject m_Main;

        private ImportedInsect(AssetImportContext context, bool flies)
        {
            m_Context = context;
            m_Flies = flies;
        }

        /// <summary>Puts an insect into an asset.</summary>
        /// <param name="context">Import of the asset.</param>
        /// <param name="species">The insect.</param>
        /// <param name="flies">Whether the prefab flies about, where the insect can.</param>
        public static void Add(AssetImportContext context, InsectDefinition species, bool flies)
        {
            var insect = new ImportedInsect(context, flies);
            insect.Keep(species);
            context.AddObjectToAsset("insect", insect.m_Main);
            context.SetMainObject(insect.m_Main);
        }

        protected override T Keep<T>(T made, string key)
        {
            m_Context.AddObjectToAsset(key, made);
            return made;
        }

        protected override Material KeepMaterial(Material made, string key)
        {
            if (made.SurfaceTexture() is Texture2D painted && painted != null)
            {
                painted.name = made.name;
                Keep(painted, key + " picture");
            }

            return Keep(made, key);
        }

        // The one that flies comes last.
        protected override void KeepPrefab(GameObject made, InsectDefinition species, bool flies)
        {
            if (flies && !m_Flies)
            {
                Object.DestroyImmediate(made);
                return;
            }

            if (m_Main != null)
                Object.DestroyImmediate(m_Main);
            made.name = species.DisplayName;
            made.SetActive(true);
            m_Main = made;
        }
    }
}
