using System.Globalization;
using Engraver.TestKit;

namespace Engraver.Simulator.Tests.Motion;

/// <summary>Spans of constant speed are skipped, with the same result: two controllers receive the same commands and the same time, and one of them steps every
/// sample.</summary>
public class SteadyMotionTests
{
    private const string Operands = "_CSS,_AVS,_VPA,_VPB,_RPA,_RPB,_RPC,_TPA,_TVA,_TVB,_VMS,_BGS,_BGA,_SCA,_NO,w,TIME";

    public static TheoryData<int> Seeds => [.. Enumerable.Range(0, TestExtent.Cases(perCommit: 8, full: 60, "ENGRAVER_STEADY_SEEDS"))];

    [Theory]
    [MemberData(nameof(Seeds))]
    public async Task Jumping_and_stepping_give_the_same_rows_times_and_operands(int seed)
    {
        await using var jumping = new SimulatorRig();
        await using var stepping = new SimulatorRig(new SimulatorOptions { JumpsSteadyMotion = false });
        var random = new Random(seed);

        foreach (var (command, milliseconds) in Session(random))
        {
            Assert.Equal(stepping.Ask(command), jumping.Ask(command));
            stepping.Pass(milliseconds);
            jumping.Pass(milliseconds);
            Assert.Equal(stepping.Ask("MG " + Operands), jumping.Ask("MG " + Operands));
        }

        Assert.Equal(stepping.Controller.Status, jumping.Controller.Status);
        Assert.Equal(stepping.Controller.Record.Snapshot(), jumping.Controller.Record.Snapshot());
        Assert.Equal(Csv(stepping), Csv(jumping));
    }

    /// <summary>Each reading of "&lt;" and "&gt;" (galil-dmc.md B.4), alone and together.</summary>
    [Theory]
    [MemberData(nameof(Seeds))]
    public async Task Jumping_and_stepping_give_the_same_rows_with_speeds_at_segments(int seed)
    {
        for (var switches = 0; switches < 8; switches++)
        {
            var options = new SimulatorOptions { EarlyRamps = (switches & 1) > 0, OnePendingExit = (switches & 2) > 0, OwnEntrySpeed = (switches & 4) > 0 };
            var random = new Random(seed);
            await using var jumping = new SimulatorRig(options);
            await using var stepping = new SimulatorRig(options with { JumpsSteadyMotion = false });
            foreach (var rig in (SimulatorRig[])[jumping, stepping]) rig.Do("VMAB", "VS 9000", "VA 200000", "VD 300000");

            for (var i = 0; i < 12; i++)
            {
                var (segment, milliseconds) = (SegmentWithSpeeds(random) + (i == 3 ? ";BGS" : ""), i < 3 ? 0 : random.Next(700));
                Assert.Equal(stepping.Ask(segment), jumping.Ask(segment));
                stepping.Pass(milliseconds);
                jumping.Pass(milliseconds);
                Assert.Equal(stepping.Ask("MG " + Operands), jumping.Ask("MG " + Operands));
            }

            foreach (var rig in (SimulatorRig[])[jumping, stepping]) rig.Do("VE").Pass(900_000);
            Assert.True(stepping.Controller.Status.IsIdle);
            Assert.Equal(stepping.Controller.Record.Snapshot(), jumping.Controller.Record.Snapshot());
        }
    }

    [Theory]
    [MemberData(nameof(Seeds))]
    public async Task A_program_is_released_in_the_same_sample(int seed)
    {
        await using var jumping = new SimulatorRig();
        await using var stepping = new SimulatorRig(new SimulatorOptions { JumpsSteadyMotion = false });
        var program = Program(new Random(seed));
        foreach (var rig in (SimulatorRig[])[jumping, stepping]) rig.Download(program).Do("XQ#JOB", "XQ#SIDE,1");

        while (!stepping.Controller.Status.IsIdle && stepping.Controller.Status.Sample < 400_000) stepping.Pass(50_000);
        while (!jumping.Controller.Status.IsIdle && jumping.Controller.Status.Sample < 400_000) jumping.Pass(50_000);

        Assert.Equal(stepping.Controller.Record.Snapshot(), jumping.Controller.Record.Snapshot());
        foreach (var operand in (string[])["t0", "t1", "t2", "t3", "t4", "ua", "ub", "_ED", "_ED1"]) Assert.Equal(stepping.Ask("MG " + operand), jumping.Ask("MG " + operand));
    }

    /// <summary>A program that waits for room in the buffer tests it every sample; its loop is skipped without being executed.</summary>
    [Theory]
    [MemberData(nameof(Seeds))]
    public async Task A_program_that_waits_for_room_goes_on_in_the_same_sample(int seed)
    {
        var (random, counter) = (new Random(seed), new Counter());
        await using var jumping = new SimulatorRig();
        await using var stepping = new SimulatorRig(new SimulatorOptions { JumpsSteadyMotion = false });
        using var heard = jumping.Controller.Record.Subscribe(counter);
        string[] program =
        [
            "#JOB", "n=0", "m=0", $"VMAB;VS {random.Next(2000, 30_000)};VA 1000000;VD 1000000", "#MORE", "n=n+1", $"VP n*{random.Next(100, 20_000)},n*{random.Next(0, 400)}",
            "JP#GOES,n>1", "BGS", "#GOES", "JS#ROOM", "JP#MORE,n<60", "VE", "AMS", "EN",
            "#ROOM", .. random.Next(2) == 0 ? (string[])["JP#GONE,m=1"] : [], .. random.Next(2) == 0 ? (string[])["JP#GONE,(_BGA=5)|(@OUT[1]=1)"] : [], $"JP#ROOM,_LMS<{random.Next(500, 511)}", "t=TIME", "EN", "#GONE", "EN",
        ];
        foreach (var rig in (SimulatorRig[])[jumping, stepping]) rig.Download(string.Join('\n', program)).Do("XQ#JOB");

        while (!stepping.Controller.Status.IsIdle && stepping.Controller.Status.Sample < 400_000) stepping.Pass(50_000);
        while (!jumping.Controller.Status.IsIdle && jumping.Controller.Status.Sample < 400_000) jumping.Pass(50_000);

        Assert.Equal(stepping.Controller.Record.Snapshot(), jumping.Controller.Record.Snapshot());
        foreach (var operand in (string[])["t", "n", "m", "_ED", "_ED1", "_NO"]) Assert.Equal(stepping.Ask("MG " + operand), jumping.Ask("MG " + operand));
        Assert.Equal(60.0, jumping.Value("n"));
        if (counter.Rows > 100_000) Assert.True(counter.Singles < counter.Rows / 2);
    }

    /// <summary>A query that will be refused when its line is executed does not fail earlier: the thread ends with its error, as when stepped, at the same
    /// sample.</summary>
    [Theory]
    [InlineData("nosuch=0")]
    [InlineData("@OUT[9]=0")]
    [InlineData("(((1=1)")]
    public async Task A_question_that_is_refused_ends_its_thread_and_nothing_else(string condition)
    {
        for (var lines = 0; lines < 40; lines++)
        {
            await using var jumping = new SimulatorRig();
            await using var stepping = new SimulatorRig(new SimulatorOptions { JumpsSteadyMotion = false });
            string[] program = ["#JOB", "VMAB;VS 20000;VA 1000000;VD 1000000", "VP 60000,0;VE;BGS", "WT 500", .. Enumerable.Repeat("NO", lines), "#ASK", $"JP#ASK,{condition}", "EN"];
            foreach (var rig in (SimulatorRig[])[jumping, stepping])
            {
                rig.Download(string.Join('\n', program)).Do("XQ#JOB");
                rig.Pass(5000);
            }

            foreach (var operand in (string[])["_RPA", "_ED", "_ED1", "_NO", "_TC"]) Assert.Equal(stepping.Ask("MG " + operand), jumping.Ask("MG " + operand));
            Assert.Equal(stepping.Controller.Record.Snapshot(), jumping.Controller.Record.Snapshot());
        }
    }

    [Fact]
    public async Task A_long_line_is_a_few_spans_and_single_samples()
    {
        var counter = new Counter();
        await using var rig = new SimulatorRig();
        rig.Controller.Record.Subscribe(counter);
        rig.Do("VMAB", "VS 20000", "VA 500000", "VD 500000", "VP 8000000,0", "VE", "BGS");

        Assert.True(rig.Controller.AdvanceToRest(TimeSpan.FromHours(2), TimeSpan.FromMinutes(1), 100_000).Status.IsIdle);

        Assert.Equal(8_000_000, rig.Value("_RPA"));
        Assert.InRange(counter.Spans, 1, 3);
        Assert.InRange(counter.Singles, 1, 200);
        Assert.Equal(400_000.0, counter.Rows, 1000.0);
    }

    [Fact]
    public async Task Listeners_are_told_what_a_record_that_keeps_nothing_does_not_keep()
    {
        var counter = new Counter();
        await using var rig = new SimulatorRig(new SimulatorOptions { KeepsRecord = false });
        using (rig.Controller.Record.Subscribe(counter)) rig.Do("PRA=100000", "BGA").RunToIdle();
        var heard = counter.Rows;
        rig.Do("PRA=100000", "BGA").RunToIdle();

        Assert.Equal(0, rig.Controller.Record.Count);
        Assert.True(heard > 4000);
        Assert.Equal(heard, counter.Rows);
    }

    private static string Csv(SimulatorRig rig)
    {
        var text = new StringWriter(CultureInfo.InvariantCulture);
        rig.Controller.Record.WriteCsv(text);
        return text.ToString();
    }

    private static IEnumerable<(string Command, int Milliseconds)> Session(Random random)
    {
        yield return ("SPA=1000;SPB=2500;SPC=30000;ACA=100000;DCA=150000;VS 5000;VA 200000;VD 300000;w=0", 1);
        for (var i = 0; i < 25; i++)
        {
            yield return (Command(random), random.Next(10) switch { 0 => 0, < 4 => random.Next(50), < 8 => random.Next(2000), _ => random.Next(20_000) });
        }

        yield return ("CB1", 30_000);
    }

    private static string Command(Random random) => random.Next(20) switch
    {
        0 => $"PRA={random.Next(-60000, 60000)};BGA",
        1 => $"PAB={random.Next(-60000, 60000)};BGB",
        2 => $"PRC={random.Next(-60000, 60000)};BGC",
        3 => $"JGC={random.Next(-3000, 3000)};BGC",
        4 => $"SPA={random.Next(1, 400) * 50.0}",
        5 => $"SPB={random.Next(1, 400) * 33.0}",
        6 => "STC",
        7 => $"VR {random.Next(0, 20) / 10.0}".Replace(',', '.'),
        8 => "SB1",
        9 => "CB1",
        10 => "STS",
        11 => $"FLA={random.Next(1000, 50000)};BLA={-random.Next(1000, 50000)}",
        12 => "VR 1",
        13 => "DPC=100",
        14 => "ACA=20000;DCA=7000",
        15 => "MG _AVS",
        _ => Sequence(random),
    };

    private static string SegmentWithSpeeds(Random random)
    {
        var entry = random.Next(2) == 0 ? $"<{random.Next(10, 300) * 50}" : "";
        var exit = random.Next(2) == 0 ? $">{(random.Next(8) == 0 ? 0 : random.Next(10, 300) * 50)}" : "";
        return $"{(random.Next(6) == 0 ? $"VS {random.Next(10, 300) * 50};" : "")}VP {random.Next(-20000, 20000)},{random.Next(-20000, 20000)}{entry}{exit}";
    }

    private static string Sequence(Random random)
    {
        var sweep = random.Next(-400, 400) + 0.5;
        return $"VM{(random.Next(4) == 0 ? "BA" : "AB")};{(random.Next(4) == 0 ? "ES 3,4;" : "")}VS {random.Next(1, 300) * 40};VP {random.Next(-30000, 30000)},{random.Next(-30000, 30000)};BGS;"
            + $"CR {random.Next(10, 20000)},{random.Next(-180, 180)},{sweep.ToString(CultureInfo.InvariantCulture)};VE";
    }

    /// <summary>Waits of every kind in two threads while the axes move.</summary>
    private static string Program(Random random)
    {
        string Wait() => random.Next(10) switch
        {
            0 => "AMS",
            1 => $"AV {random.Next(0, 30000)}",
            2 => "ASS",
            3 => $"WT {random.Next(2, 3000)}",
            4 => $"MF {random.Next(-8000, 8000)}",
            5 => $"MR ,{random.Next(-8000, 8000)}",
            6 => $"AR ,,{random.Next(10, 8000)}",
            7 => $"AP ,,{random.Next(-8000, 8000)}",
            8 => $"AD ,,{random.Next(10, 8000)}",
            _ => "AMC",
        };
        return $"""
            #JOB
            VA 300000;VD 300000;SPC={random.Next(1, 90) * 100}
            VMAB;VS {random.Next(1, 300) * 40};VP {random.Next(-30000, 30000)},{random.Next(-30000, 30000)}
            CR {random.Next(500, 9000)},{random.Next(-180, 180)},{random.Next(20, 360)};VE
            PRC={random.Next(-20000, 20000)};BGC;BGS
            {Wait()};t0=TIME;SB1
            {Wait()};t1=TIME;CB1
            {Wait()};t2=TIME;SB2
            AMS;AMC;t3=TIME
            PRA={random.Next(-20000, 20000)};BGA;AMA;t4=TIME
            EN
            #SIDE
            {Wait()};ua=TIME
            {Wait()};ub=TIME
            EN
            """;
    }

    private sealed class Counter : IMotionListener
    {
        public long Rows { get; private set; }

        public int Spans { get; private set; }

        public int Singles { get; private set; }

        public void Add(in MotionSample sample)
        {
            Rows++;
            Singles++;
        }

        public void Add(MotionSpan span)
        {
            Rows += span.Count;
            Spans++;
        }
    }
}
