using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>Nodes beside an insect in a glTF file, which move in a loop of whole beats.</summary>
internal interface IGlbLoop
{
    /// <summary>Beats of the loop.</summary>
    int Beats { get; }

    /// <summary>Adds its nodes.</summary>
    void AddTo(GlbScene scene, GlbLooks looks);

    /// <summary>Adds its loop to an animation.</summary>
    /// <param name="animation">Where to.</param>
    /// <param name="period">Seconds of a beat.</param>
    void Animate(JsonObject animation, double period);
}
