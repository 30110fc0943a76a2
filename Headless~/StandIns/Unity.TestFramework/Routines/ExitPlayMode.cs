using System.Collections;
using Unity.StandIns;

namespace UnityEngine.TestTools;

public class ExitPlayMode : IEditModeTestYieldInstruction
{
    public bool ExpectDomainReload => false;

    public bool ExpectedPlaymodeState => false;

    public IEnumerator Perform()
    {
        PlayerLoop.ExitPlayMode();
        yield return null;
    }
}
