// Tests of the engine's stand-ins run as tests run in Unity: in play mode, and none may log an error that it did not expect.
[assembly: StandIns.PlayerTests("Unity.Tests.Engine")]
[assembly: StandIns.TestOrder("ALATE_TEST_ORDER")]
