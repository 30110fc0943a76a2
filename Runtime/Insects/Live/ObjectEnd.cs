using UnityEngine;

namespace Alate
{
    /// <summary>The right way to destroy, in play, at its end and in the editor.</summary>
    internal static class ObjectEnd
    {
        public static void Destroy(Object target)
        {
            if (target == null)
                return;
            if (Application.isPlaying && !PlayEnd.HasCome)
                Object.Destroy(target);
            else
                Object.DestroyImmediate(target);
        }
    }
}
