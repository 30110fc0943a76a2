namespace UnityEngine;

public sealed class AudioSettings
{
    public delegate void AudioConfigurationChangeHandler(bool deviceWasChanged);

    public static event AudioConfigurationChangeHandler OnAudioConfigurationChanged;

    public static int outputSampleRate
    {
        get => s_SampleRate;
        set
        {
            s_SampleRate = value;
            OnAudioConfigurationChanged?.Invoke(false);
        }
    }

    private static int s_SampleRate = 48000;
}
