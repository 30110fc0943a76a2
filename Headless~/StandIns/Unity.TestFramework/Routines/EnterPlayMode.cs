using System.Collections;
using Unity.StandIns;

namespace UnityEngine.TestTools;

public class EnterPlayMode(bool expectDomainReload = true) : IEditModeTestYieldInstruction
{
    public bool ExpectDomainReload { get; } = expectDomainReload;

    public bool ExpectedPlaymodeState => true;

    public IEnumerator Perform()
    {
        PlayerLoop.EnterPlayMode();
        yield return null;
    }
}
