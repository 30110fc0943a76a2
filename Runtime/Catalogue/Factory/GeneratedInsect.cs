using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate.Catalogue
{
    /// <summary>
    /// Holds the parts that an insect made by <see cref="InsectFactory"/> shares with others of its species: they are freed when the last
    /// insect, clones included, is destroyed.
    /// </summary>
    [AddComponentMenu("")]
    [DisallowMultipleComponent]
    [MovedFrom(true, "Alate", "Alate")]
    internal sealed class GeneratedInsect : MonoBehaviour
    {
        // Serialised, so that a clone knows it too.
        [SerializeField, HideInInspector]
        private string m_Parts;

        /// <summary>Key of the parts.</summary>
        internal string Parts
        {
            set => m_Parts = value;
        }

        private void Awake() => GeneratedAssets.Acquire(m_Parts);

        private void OnEnable() => PlayEnd.Listen();

        private void OnDestroy() => GeneratedAssets.Return(m_Parts);
    }
}
