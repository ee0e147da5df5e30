using System.Globalization;

namespace Engraver.Simulator.Tests.Fuzzing;

/// <summary>No command from a client, and no byte, may end the process or silence a connection. <c>ENGRAVER_FUZZ_LINES=5000000</c> and <c>ENGRAVER_FUZZ_SEED=n</c> go further than CI does.</summary>
public class FuzzTests
{
    private const int LinesOfOne = 1000;

    [Fact]
    public async Task Whatever_a_client_sends_the_controller_lives_and_answers()
    {
        var runs = Setting("ENGRAVER_FUZZ_LINES", 200_000) / LinesOfOne;
        var first = Setting("ENGRAVER_FUZZ_SEED", 1);
        for (var seed = first; seed < first + runs; seed++)
        {
            await using var controller = new FuzzedController(seed);
            var found = controller.Run(LinesOfOne);
            Assert.True(found is null, found);
        }
    }

    private static int Setting(string name, int otherwise) => int.TryParse(Environment.GetEnvironmentVariable(name), NumberStyles.None, CultureInfo.InvariantCulture, out var value) ? value : otherwise;
}
