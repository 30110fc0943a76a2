using UnityEngine;

namespace Alate.Cli;

/// <summary>Pictures of the sample scenes for the documentation: the film of the front page, and a still of each sample.</summary>
internal static class SceneFigures
{
    /// <summary>The film of the front page.</summary>
    public const string Film = "images/garden-film.png";

    private const int k_StillWidth = 480;

    /// <summary>All of them, in the folder of the documentation.</summary>
    public static IEnumerable<string> Files => [Film, .. SampleScene.All.Select(Still)];

    /// <summary>
    /// A monarch that comes in, lands on a flower, folds its wings, basks and takes off again, among others. Flights depend on where the
    /// camera is and how long a frame is: another view shows other ones.
    /// </summary>
    internal static SceneFilmPlan Garden => new()
    {
        Scene = SampleScene.Find("garden"),
        Settings = ["Butterflies=12", "Shy=0"],
        Look = [10.0, 12.0, 4.2, 3.2, 4.9, -3.4],
        After = 79.2,
        Seconds = 12.6,
        Rate = 20,
        Width = 640,
    };

    /// <summary>Makes all of them.</summary>
    /// <param name="write">Told the name and the content of each.</param>
    public static void Make(Action<string, byte[]> write)
    {
        SceneFilmPlan garden = Garden;
        write(Film, IndexedPng.Write(
            garden.Size.x, garden.Size.y, SceneFilm.Play(garden, _ => { }), garden.Rate, true,
            ["A monarch lands on a flower, folds its wings, basks and flies on"]));
        foreach (SampleScene scene in SampleScene.All)
        {
            SceneFilmPlan still = StillOf(scene);
            Color32[] picture = SceneFilm.Play(still, _ => { })[^1];
            write(Still(scene), TrueColourPng.Write(still.Size.x, still.Size.y, picture, [$"The sample {scene.Folder}"]));
        }
    }

    /// <summary>File of the still of a sample.</summary>
    internal static string Still(SampleScene scene) => $"images/sample-{scene.Name}.png";

    // As the sample looks by itself, but for the moment and a view that is not from afar; chosen by eye.
    private static SceneFilmPlan StillOf(SampleScene scene)
    {
        var still = new SceneFilmPlan { Scene = scene, Seconds = 1.0 / 60.0, Rate = 60, Width = k_StillWidth, After = 2.0 };
        return scene.Name switch
        {
            "comparison" => still with { After = 2.3 },
            "garden" => still with { After = 24.0 },
            "meadow" => still with { Look = [145.0, 12.0, 5.0] },
            "swarm" => still with { Look = [145.0, 12.0, 6.0] },
            _ => still,
        };
    }
}
