[assembly: StandIns.PlayerTests("Alate.Tests.Play")]
[assembly: StandIns.TestOrder("ALATE_TEST_ORDER")]
