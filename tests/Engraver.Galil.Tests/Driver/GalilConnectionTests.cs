using Engraver.Core.Machines;
using Engraver.Galil.Driver;
using Engraver.Galil.Tests.Jobs;
using Engraver.Links;
using Engraver.Links.Recording;

namespace Engraver.Galil.Tests.Driver;

public class GalilConnectionTests
{
    [Fact]
    public async Task A_stop_without_a_job_goes_out_in_one_line_with_the_tool_first_and_every_axis()
    {
        var sent = await SentBetweenAsync(connection => connection.StopAsync(2));

        Assert.Equal("CB 2;STS;ST ABCD", sent[0]);
    }

    [Fact]
    public async Task Each_part_of_a_stop_is_tried_again_on_its_own_for_one_that_is_refused_ends_its_line()
    {
        var sent = await SentBetweenAsync(connection => connection.StopAsync(2));

        Assert.Equal(["CB 2", "STS", "ST ABCD"], sent.Skip(1));
    }

    [Fact]
    public async Task An_abort_halts_before_anything_else_and_ends_with_the_motors_off()
    {
        var sent = await SentBetweenAsync(connection => connection.AbortAsync(1));

        Assert.Equal(["AB", "CB 1", "MOABCD"], sent);
    }

    [Fact]
    public async Task What_a_look_tells_is_in_neutral_words()
    {
        await using var bench = new SimulatedBench();
        await using var connection = await OpenAsync(bench, trace: null);
        Assert.Null(await connection.SetMotorsAsync(MachineAxes.Default, on: false, CancellationToken.None));
        bench.Controller.SetLimitSwitch(1, forward: false, active: true);

        var found = await connection.ReadStatusAsync(MachineAxes.Default, CancellationToken.None);

        Assert.Equal((0, 0, false, "AB", "the reverse limit of axis Y", "", false), (found.X, found.Y, found.IsMoving, found.MotorsOff, found.Limit, found.LostPosition, found.AbortInput));
        Assert.False(connection.Capabilities.IsSingleWire);
        Assert.Equal(4, connection.Identity.Axes);
    }

    private static async Task<IReadOnlyList<string>> SentBetweenAsync(Func<IMachineConnection, Task> act)
    {
        await using var bench = new SimulatedBench();
        var text = new StringWriter();
        var trace = new WireTrace(text, TimeProvider.System);
        var connection = await OpenAsync(bench, trace);
        await using (connection)
        {
            await connection.ExecuteLineAsync("MG 4711", CancellationToken.None);
            await act(connection);
            await connection.ExecuteLineAsync("MG 4712", CancellationToken.None);
        }

        await trace.CloseAsync(CancellationToken.None);
        var sent = text.ToString().Split('\n').Where(line => line.Contains(" > ", StringComparison.Ordinal)).Select(line => line[(line.IndexOf(" > ", StringComparison.Ordinal) + 3)..].Trim()).ToList();
        return [.. sent.SkipWhile(line => line != "MG 4711").Skip(1).TakeWhile(line => line != "MG 4712")];
    }

    private static Task<GalilConnection> OpenAsync(SimulatedBench bench, WireTrace? trace) => GalilConnection.OpenAsync(
        _ => Task.FromResult<IControllerLink>(new StreamLink(bench.Controller.OpenConnection(), "memory")), trace, bench.Clock, CancellationToken.None);
}
