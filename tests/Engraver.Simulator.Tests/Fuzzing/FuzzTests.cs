using Engraver.TestKit;

namespace Engraver.Simulator.Tests.Fuzzing;

/// <summary>No command from a client, and no byte, may end the process or block a connection. <c>ENGRAVER_FUZZ_LINES=5000000</c> and
/// <c>ENGRAVER_FUZZ_SEED=n</c> extend it.</summary>
public class FuzzTests
{
    private const int LinesOfOne = 1000;

    [Fact]
    public async Task Whatever_a_client_sends_the_controller_lives_and_answers()
    {
        var runs = TestExtent.Cases(perCommit: 20_000, full: 1_000_000, "ENGRAVER_FUZZ_LINES") / LinesOfOne;
        var first = TestExtent.Number("ENGRAVER_FUZZ_SEED", 1);
        for (var seed = first; seed < first + runs; seed++)
        {
            await using var controller = new FuzzedController(seed);
            var found = controller.Run(LinesOfOne);
            Assert.True(found is null, found);
        }
    }
}
