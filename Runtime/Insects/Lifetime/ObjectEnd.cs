using UnityEngine;

namespace Alate
{
    /// <summary>Destroys objects in the way that fits play, its end and the editor.</summary>
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
