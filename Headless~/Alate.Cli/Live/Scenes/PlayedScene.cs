using Unity.StandIns;

namespace Alate.Cli;

/// <summary>Play mode in which components live, for as long as somebody needs it.</summary>
internal static class PlayedScene
{
    private static int s_Users;
    private static bool s_HasEntered;

    /// <summary>Number of places that have been given away.</summary>
    private static int s_Places;

    /// <summary>Begins to play, unless it plays already. Called on the simulation's thread.</summary>
    /// <returns>Number of a place of one's own.</returns>
    public static int Enter()
    {
        if (s_Users++ == 0 && !PlayerLoop.IsPlaying)
        {
            PlayerLoop.EnterPlayMode();
            s_HasEntered = true;
        }

        return s_Places++;
    }

    /// <summary>Plays no more with the last user, where it was begun here.</summary>
    public static void Leave()
    {
        if (--s_Users > 0 || !s_HasEntered)
            return;
        s_HasEntered = false;
        PlayerLoop.ExitPlayMode();
    }

    /// <summary>Lets a frame pass.</summary>
    public static void Tick(float seconds) => PlayerLoop.Tick(seconds);
}
