namespace UnityEngine;

public sealed class AudioListener : AudioBehaviour
{
}
