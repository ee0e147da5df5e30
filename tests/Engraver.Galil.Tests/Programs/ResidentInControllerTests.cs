using Engraver.Core.Machines;
using Engraver.Galil.Programs.Resident;

namespace Engraver.Galil.Tests.Programs;

/// <summary>The resident programs run in a simulated controller with a host.</summary>
public class ResidentInControllerTests
{
    [Fact]
    public async Task The_papers_part_by_calls_of_the_host()
    {
        await using var bench = Started(ResidentProgram.ForCalls(MachineProfile.Default));

        Call(bench, 1, "x=5000;y=5000;op=3");
        Call(bench, 2, "x=1;op=4");
        Call(bench, 3, "x=10000;y=0;op=1");
        Call(bench, 4, "x=0;y=10000;op=1");
        Call(bench, 5, "r=5000;th=0;da=180;op=2");
        Call(bench, 6, "x=0;y=-10000;op=1");
        Call(bench, 7, "x=0;op=4");

        Assert.Equal((5000.0, 5000.0, 7.0, 1.0, 0.0), (bench.Value("_RPA"), bench.Value("_RPB"), bench.Value("seq"), bench.Value("done"), bench.Value("errcode")));
        Assert.Equal(0, bench.Status.Outputs);
    }

    [Fact]
    public async Task A_host_that_falls_silent_has_the_tool_off_and_the_machine_stopped_after_a_second()
    {
        await using var bench = Started(ResidentProgram.ForCalls(MachineProfile.Default));
        Call(bench, 1, "x=1;op=4");
        bench.Do("hb=20;x=1000000;y=0;op=1;go=1");

        bench.Pass(900);
        Assert.True(bench.Status is { Outputs: 1, IsMoving: true });

        bench.Pass(500);
        Assert.True(bench.Status is { Outputs: 0, IsMoving: false, RunningThreads: 0 });
        Assert.Equal((1.0, 1.0), (bench.Value("wtrip"), bench.Value("seq")));
        Assert.All(bench.Record.SkipWhile(row => row.Outputs == 0).SkipWhile(row => row.Outputs == 1), row => Assert.Equal(0, row.Outputs));
    }

    [Fact]
    public async Task A_rapid_is_stopped_too()
    {
        await using var bench = Started(ResidentProgram.ForCalls(MachineProfile.Default));
        bench.Do("x=1000000;y=1000000;op=3;go=1");

        bench.Pass(1500);

        Assert.True(bench.Status is { IsMoving: false, RunningThreads: 0 });
        Assert.InRange(bench.Value("_RPA"), 1.0, 100_000.0);
    }

    [Fact]
    public async Task A_stream_is_stopped_and_what_was_buffered_is_not_cut_any_more()
    {
        await using var bench = Started(ResidentProgram.ForStream(MachineProfile.Default));
        foreach (var command in new[] { "VMAB", "VP 1000000,0", "VP 1000000,1000000", "VE", "SB1", "BGS" }) bench.Do(command);

        bench.Pass(1500);
        var stopped = bench.Value("_RPA");
        bench.Pass(5000);

        Assert.Equal((1.0, 0.0, stopped), (bench.Value("wtrip"), bench.Value("_BGS"), bench.Value("_RPA")));
        Assert.Equal(0, bench.Status.Outputs);
        bench.Do("CSS");
    }

    [Fact]
    public async Task A_host_that_assigns_the_heartbeat_is_left_alone()
    {
        await using var bench = Started(ResidentProgram.ForStream(MachineProfile.Default));

        for (var i = 0; i < 20; i++)
        {
            bench.Pass(300);
            bench.Do("hb=20");
        }

        Assert.Equal((0.0, 3), (bench.Value("wtrip"), bench.Status.RunningThreads));
    }

    [Theory]
    [InlineData("stream")]
    [InlineData("calls")]
    public async Task A_tool_that_is_on_while_nothing_moves_goes_off_although_the_host_lives(string way)
    {
        await using var bench = Started(way == "stream" ? ResidentProgram.ForStream(MachineProfile.Default) : ResidentProgram.ForCalls(MachineProfile.Default));
        bench.Do("SB1");

        PassFed(bench, seconds: 5.5);
        Assert.Equal((1, 0.0), (bench.Status.Outputs, bench.Value("wtrip")));

        PassFed(bench, seconds: 1.5);
        Assert.Equal((0, 2.0, 0), (bench.Status.Outputs, bench.Value("wtrip"), bench.Status.RunningThreads));
    }

    [Fact]
    public async Task A_sequence_that_is_held_by_VR_0_is_stopped_and_one_that_creeps_is_not()
    {
        await using var bench = Started(ResidentProgram.ForStream(MachineProfile.Default));
        foreach (var command in new[] { "VMAB", "VS 2000", "VP 100000,0", "VE", "SB1", "BGS", "VR 0.001" }) bench.Do(command);

        PassFed(bench, seconds: 20.0);
        Assert.Equal((0.0, 1.0, 1), (bench.Value("wtrip"), bench.Value("_BGS"), bench.Status.Outputs));

        bench.Do("VR 0");
        PassFed(bench, seconds: 8.0);
        Assert.Equal((2.0, 0), (bench.Value("wtrip"), bench.Status.Outputs));
        bench.Do("VR 1");
        bench.Pass(1000);
        Assert.Equal(0.0, bench.Value("_BGS"));
    }

    [Fact]
    public async Task A_host_that_feeds_slowly_with_the_tool_on_is_left_alone()
    {
        await using var bench = Started(ResidentProgram.ForStream(MachineProfile.Default));
        foreach (var command in new[] { "SB1", "VMAB" }) bench.Do(command);

        for (var i = 1; i <= 10; i++)
        {
            bench.Do($"VP {i * 100},0");
            PassFed(bench, seconds: 3.0);
        }

        Assert.Equal((0.0, 1), (bench.Value("wtrip"), bench.Status.Outputs));
    }

    [Fact]
    public async Task A_standstill_without_the_tool_lasts_as_long_as_it_likes()
    {
        await using var bench = Started(ResidentProgram.ForCalls(MachineProfile.Default));

        PassFed(bench, seconds: 60.0);

        Assert.Equal((0.0, 3), (bench.Value("wtrip"), bench.Status.RunningThreads));
    }

    [Fact]
    public async Task A_refused_call_is_reported_and_the_server_takes_no_other()
    {
        await using var bench = Started(ResidentProgram.ForCalls(MachineProfile.Default));
        Call(bench, 1, "x=1;op=4");

        bench.Do("r=5;th=0;da=90;op=2;go=1");
        bench.Pass(200);
        Assert.Equal((6.0, 1.0, 0), (bench.Value("errcode"), bench.Value("seq"), bench.Status.Outputs));

        bench.Do("hb=20;x=100;y=0;op=1;go=1");
        bench.Pass(500);
        Assert.Equal((1.0, 0.0, 3), (bench.Value("seq"), bench.Value("_RPA"), bench.Status.RunningThreads));
    }

    private static ControllerBench Started(ResidentProgram program)
    {
        var bench = new ControllerBench();
        bench.Download(program.Text);
        bench.Do("SHAB");
        bench.Do("hb=20;stillmax=120");
        bench.Do($"XQ{program.EntryLabel},{ResidentProgram.MainThread}");
        bench.Pass(50);
        return bench;
    }

    /// <summary>Lets time pass while the host sends heartbeats.</summary>
    private static void PassFed(ControllerBench bench, double seconds)
    {
        for (var passed = 0.0; passed < seconds; passed += 0.25)
        {
            bench.Do("hb=20");
            bench.Pass(250);
        }
    }

    /// <summary>Assigns a call and waits for its end like the host: by seq, with heartbeats.</summary>
    private static void Call(ControllerBench bench, int seq, string assignments)
    {
        bench.Do($"{assignments};go=1");
        for (var i = 0; i < 1000 && bench.Value("seq") < seq; i++)
        {
            bench.Pass(10);
            bench.Do("hb=20");
        }

        Assert.Equal(seq, bench.Value("seq"));
    }
}
