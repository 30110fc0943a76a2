using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>Acts while the jobs of earlier fixed steps are under way.</summary>
    internal sealed class ActInFixedUpdate : MonoBehaviour
    {
        public Zoo zoo;

        private void FixedUpdate() => zoo.ActOnce();
    }
}
