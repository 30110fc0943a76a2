namespace UnityEngine;

public class AudioBehaviour : Behaviour
{
}

/// <summary>A source that plays nothing: there is no sound here.</summary>
public sealed class AudioSource : AudioBehaviour, IStateful
{
    public AudioClip clip { get; set; }
    public bool loop { get; set; }
    public float dopplerLevel { get; set; } = 1f;
    public bool isPlaying { get; private set; }

    public void Play() => isPlaying = clip != null && isActiveAndEnabled;

    public void Stop() => isPlaying = false;

    void IStateful.CopyStateTo(Component copy)
    {
        var to = (AudioSource)copy;
        to.clip = clip;
        to.loop = loop;
        to.dopplerLevel = dopplerLevel;
    }
}
