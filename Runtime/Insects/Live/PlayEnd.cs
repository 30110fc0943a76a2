using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Knows when play has ended: the game in a player, play mode in the editor. From then on nothing starts any more, and what is destroyed must be so at once, because no
    /// frame comes that would end it.
    /// </summary>
    internal static class PlayEnd
    {
        static PlayEnd() => Application.quitting += OnQuitting;

        /// <summary>Whether play has ended.</summary>
        public static bool HasCome { get; private set; }

        /// <summary>Makes sure that the end will be heard; a recompile during play forgets who listens.</summary>
        public static void Listen()
        {
            // The first call of anything here runs the static constructor.
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void Forget()
        {
            HasCome = false;
            Application.quitting -= OnQuitting;
            Application.quitting += OnQuitting;
        }

        private static void OnQuitting()
        {
            HasCome = true;
            WingSystem.EndWithPlay();
        }
    }
}
