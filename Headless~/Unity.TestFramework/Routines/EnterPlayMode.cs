using System.Collections;
using Unity.StandIns;

namespace UnityEngine.TestTools;

/// <summary>What an edit-mode test yields to change what the editor does.</summary>
public interface IEditModeTestYieldInstruction
{
    bool ExpectDomainReload { get; }
    bool ExpectedPlaymodeState { get; }
    IEnumerator Perform();
}

/// <summary>Enters play mode; there is no domain reload.</summary>
public class EnterPlayMode : IEditModeTestYieldInstruction
{
    public EnterPlayMode(bool expectDomainReload = true) => ExpectDomainReload = expectDomainReload;

    public bool ExpectDomainReload { get; }
    public bool ExpectedPlaymodeState => true;

    public IEnumerator Perform()
    {
        PlayerLoop.EnterPlayMode();
        yield break;
    }
}

public class ExitPlayMode : IEditModeTestYieldInstruction
{
    public bool ExpectDomainReload => false;
    public bool ExpectedPlaymodeState => false;

    public IEnumerator Perform()
    {
        PlayerLoop.ExitPlayMode();
        yield break;
    }
}
