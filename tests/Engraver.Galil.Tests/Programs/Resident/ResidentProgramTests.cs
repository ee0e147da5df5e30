using Engraver.Core.Machines;
using Engraver.Galil.Programs.Resident;

namespace Engraver.Galil.Tests.Programs.Resident;

public class ResidentProgramTests
{
    private static readonly MachineProfile OutputThree = MachineProfile.Default with { ToolOutput = 3 };

    public static TheoryData<string> Both => ["stream", "calls"];

    [Theory]
    [MemberData(nameof(Both))]
    public void Every_line_is_one_that_the_controller_takes(string way)
    {
        foreach (var line in Lines(Program(way)))
        {
            Assert.InRange(line.Length, 1, 80);
            Assert.Matches("^(#[A-Z]{1,7}|[A-Za-z][^#]*(#[A-Z]{1,7}(,.*)?)?)$", line);
        }
    }

    [Theory]
    [MemberData(nameof(Both))]
    public void Labels_are_unique_and_every_jump_has_one(string way)
    {
        var program = Program(way);

        Assert.Equal(program.Labels.Count, program.Labels.Distinct().Count());
        Assert.Contains(program.EntryLabel, program.Labels);
        var jumps = Lines(program).Where(line => line[0] != '#' && line.Contains('#', StringComparison.Ordinal)).Select(line => line[line.IndexOf('#', StringComparison.Ordinal)..].Split(',')[0]);
        Assert.All(jumps, jump => Assert.Contains(jump, program.Labels));
    }

    [Theory]
    [MemberData(nameof(Both))]
    public void Every_variable_is_assigned_before_the_loop_of_its_thread_reads_it(string way)
    {
        var program = Program(way);
        var opening = string.Join(';', Lines(program).TakeWhile(line => !line.StartsWith("WT", StringComparison.Ordinal)));

        Assert.Contains($"{ResidentProgram.Variables.ErrorCode}=0", opening, StringComparison.Ordinal);
        Assert.Contains("XQ#WDOG,1", opening, StringComparison.Ordinal);
        string[] server = way == "stream" ? [] : ["op=0", "x=0", "y=0", "r=0", "th=0", "da=0", "f=20000", "go=0", "done=1", "seq=0"];
        Assert.All(server, name => Assert.Contains(name, opening, StringComparison.Ordinal));
    }

    [Theory]
    [MemberData(nameof(Both))]
    public void The_watchdog_takes_the_tool_off_then_halts_the_feeder_then_stops_in_one_line(string way) =>
        Assert.Contains("CB3;wc=_CSS;wx=_RPA;wy=_RPB;wd=_AVS;wtrip=1;HX0;STS;STAB;wj=jm", Lines(Program(way)));

    [Fact]
    public void A_call_is_taken_up_before_it_runs_and_counted_after_it_has_run()
    {
        var lines = Lines(Program("calls"));
        int At(string line) => lines.IndexOf(line);

        Assert.Equal(At("JP#SLOOP,go=0") + 1, At("go=0;done=0"));
        Assert.True(At("go=0;done=0") < At("JS#LINEAR,op=1"));
        Assert.True(At("JS#TOOL,op=4") < At("done=1;seq=seq+1"));
        Assert.Equal(At("done=1;seq=seq+1") + 1, At("JP#SLOOP"));
    }

    [Fact]
    public void The_tool_is_the_profiles_output() => Assert.Contains("OB 3,x;WT 100", Lines(Program("calls")));

    private static ResidentProgram Program(string way) => way == "stream" ? ResidentProgram.ForStream(OutputThree) : ResidentProgram.ForCalls(OutputThree);

    private static List<string> Lines(ResidentProgram program) => [.. program.Text.TrimEnd('\n').Split('\n')];
}
