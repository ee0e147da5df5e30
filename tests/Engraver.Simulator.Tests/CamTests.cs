using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Simulator.Tests;

/// <summary>The electronic cam (galil-dmc.md C.4, A.8 codes 100 to 105, A.10 stop codes 60 and 61).</summary>
public class CamTests
{
    /// <summary>Master A, 6000 counts a cycle, points every 2000; slave B rises to 3000 and ends 1500 further.</summary>
    private static readonly string[] Table =
        ["EAA", "EM 6000,1500", "EP 2000,0", "ET[0]=,0", "ET[1]=,3000", "ET[2]=,2250", "ET[3]=,1500"];

    [Theory]
    [InlineData(1000, 1500)]
    [InlineData(2000, 3000)]
    [InlineData(3000, 2625)]
    [InlineData(5000, 1875)]
    [InlineData(5999, 1500)]
    public async Task A_slave_is_on_the_line_between_the_points_of_the_table(int master, int slave)
    {
        await using var rig = new SimulatorRig();
        rig.Do(Table).Do("EB 1", "EG ,-1");

        rig.Do($"PAA={master}", "BGA").RunToIdle();

        Assert.Equal((master, slave), (rig.Value("_RPA"), rig.Value("_RPB")));
        Assert.Equal((slave, 1, 60), (rig.Value("_TPB"), rig.Value("_EGB"), rig.Value("_SCB")));
    }

    [Property]
    public Property Wherever_the_master_goes_the_slave_is_on_its_table()
    {
        const int interval = 500;
        var table = Gen.Choose(-3000, 3000).ArrayOf(5);
        var moves = Gen.Choose(-7000, 7000).Where(m => m != 0).ArrayOf(3);
        return Prop.ForAll(table.ToArbitrary(), moves.ToArbitrary(), (points, ways) =>
        {
            var rig = new SimulatorRig();
            rig.Do("EAA", $"EM {4 * interval},{Math.Abs(points[4] - points[0])}", $"EP {interval}");
            for (var i = 0; i < points.Length; i++) rig.Do($"ET[{i}]=,{points[i]}");
            rig.Do("EB 1", "EG ,-1", "SPA=20000");
            foreach (var way in ways) rig.Do($"PRA={way}", "BGA").RunToIdle();

            var place = (int)rig.Value("_RPA");
            var (segment, rest) = Math.DivRem(place, interval);
            var wanted = points[segment] + ((points[segment + 1] - points[segment]) * (double)rest / interval);
            return place == ((ways.Sum() % 2000) + 2000) % 2000 && Math.Abs(rig.Value("_RPB") - wanted) <= 0.5;
        });
    }

    [Fact]
    public async Task Positions_are_told_within_a_cycle_while_the_motion_goes_on()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Table).Do("EB 1", "EG ,-1", "PRA=13000", "BGA").RunToIdle();

        Assert.Equal((1000, 1500), (rig.Value("_RPA"), rig.Value("_RPB")));

        rig.Do("PRA=-2000", "BGA").RunToIdle();
        Assert.Equal((5000, 1875), (rig.Value("_RPA"), rig.Value("_RPB")));
    }

    [Fact]
    public async Task The_slave_never_jumps_where_one_cycle_meets_the_next()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Table).Do("EB 1", "EG ,-1", "SPA=20000", "PRA=20000", "BGA").RunToIdle();

        var steps = rig.Controller.Record.Snapshot().Zip(rig.Controller.Record.Snapshot().Skip(1), (a, b) => b.B - a.B).ToList();

        // 20 counts of the master a sample are 30 of the slave on the steepest line; when its cycle starts again it drops by one cycle.
        Assert.All(steps, s => Assert.True(s is >= -31 and <= 31 or >= -1531 and <= -1469, $"{s}"));
        Assert.Equal(3, steps.Count(s => s < -1000));
    }

    [Fact]
    public async Task The_speed_of_a_slave_is_told_and_ends_with_its_master()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Table).Do("EB 1", "EG ,-1", "JGA=2000", "BGA").Pass(300);
        Assert.Equal(3000, rig.Value("_TVB"));

        rig.Do("STA").RunToIdle();

        Assert.Equal((0, 1), (rig.Value("_TVB"), rig.Value("_EGB")));
    }

    [Fact]
    public async Task EG_and_EQ_wait_for_their_place_of_the_master()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Table).Do("EB 1", "DPB=3000", "EG ,2000", "EQ ,4000", "SPA=10000", "PRA=1000", "BGA").RunToIdle();
        Assert.Equal((3000, 0, 3), (rig.Value("_RPB"), rig.Value("_EGB"), rig.Value("_EQB")));

        rig.Do("PRA=2000", "BGA").RunToIdle();
        Assert.Equal((1, 2), (rig.Value("_EGB"), rig.Value("_EQB")));

        rig.Do("PRA=2500", "BGA").RunToIdle();
        Assert.Equal((0, 0, 61), (rig.Value("_EGB"), rig.Value("_EQB"), rig.Value("_SCB")));
        Assert.InRange(rig.Value("_RPB"), 2240, 2250); // it stops within a sample, 10 counts of the master, after 4000
    }

    [Fact]
    public async Task A_slave_that_stands_elsewhere_jumps_to_the_table_when_it_is_engaged()
    {
        await using var rig = new SimulatorRig();
        rig.Do("PAA=1000", "BGA").RunToIdle();
        rig.Do(Table).Do("DPB=1700", "EB 1", "EG ,-1").Pass(5);

        Assert.Equal((1500, 1500, 0), (rig.Value("_RPB"), rig.Value("_TPB"), rig.Value("_TEB")));
    }

    [Fact]
    public async Task The_shift_of_EP_moves_the_graph_at_once()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Table).Do("EB 1", "EG ,-1", "PAA=2000", "BGA").RunToIdle();

        rig.Do("EP ,1000").Pass(5);

        Assert.Equal(1500, rig.Value("_RPB"));
        Assert.Equal(2000, rig.Value("_EP"));
    }

    [Theory]
    [InlineData("STB", 4)]
    [InlineData("EB 0", 61)]
    [InlineData("AB 1", 7)]
    [InlineData("EQ ,-1", 61)]
    public async Task What_ends_the_cam_lets_the_slave_stand_while_a_jogging_master_may_go_on(string end, int stopCode)
    {
        await using var rig = new SimulatorRig();
        rig.Do(Table).Do("EB 1", "EG ,-1", "JGA=1000", "BGA").Pass(500);
        Assert.NotEqual(0, rig.Value("_RPB"));

        rig.Do(end).Pass(5);
        var place = rig.Value("_RPB");

        Assert.Equal((stopCode, place, 0), (rig.Value("_SCB"), rig.Pass(200).Value("_RPB"), rig.Value("_EGB")));
    }

    [Fact]
    public async Task A_limit_switch_ends_the_cam_of_its_slave()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Switches = [new AxisSwitches(1) { ForwardLimitAt = 1000 }] });

        rig.Do(Table).Do("EB 1", "EG ,-1", "SPA=2000", "PRA=2000", "BGA").RunToIdle();

        Assert.Equal((2, 0), (rig.Value("_SCB"), rig.Value("_EGB")));
        Assert.InRange(rig.Value("_RPB"), 1000, 1010);
    }

    [Fact]
    public async Task A_virtual_master_drives_the_cam_and_gears_of_it_do_not_notice_its_cycle()
    {
        await using var rig = new SimulatorRig();
        rig.Do("EAN", "EMN=1000", "EMB=0", "EP 500", "EC 0", "ET ,0", "ET ,200", "ET ,0", "EB 1", "EG ,-1", "GAC=N", "GRC=1");

        rig.Do("PRN=2250", "BGN").RunToIdle();

        Assert.Equal((250, 100, 2250), (rig.Value("_RPN"), rig.Value("_RPB"), rig.Value("_RPC")));
        Assert.Equal(3, rig.Value("_EC"));
    }

    [Fact]
    public async Task A_program_waits_with_MF_for_the_master()
    {
        await using var rig = new SimulatorRig();
        rig.Do(Table).Run("EB 1\nEG ,1000\nDPB=1500\nPRA=4000\nBGA\nMFA=2000\nhigh=_RPB\nAMA\nlow=_RPB\nEB 0\nEN");

        Assert.InRange(rig.Value("high"), 2900, 3000);
        Assert.Equal(2250, rig.Value("low"));
    }

    [Theory]
    [InlineData("EB 1", 102)]
    [InlineData("EAA;EB 1", 102)]
    [InlineData("EAA;EMA=8000000;EB 1", 103)]
    [InlineData("EG ,0", 105)]
    [InlineData("ET[257]=,1", 101)]
    [InlineData("EC -1", 101)]
    [InlineData("EAS", 4)]
    [InlineData("EAA=1", 4)]
    [InlineData("EP 40000", 6)]
    [InlineData("EAA;EM 6000;EB 1;EAB", 100)]
    [InlineData("EAA;EM 6000;EB 1;EM 5000", 100)]
    [InlineData("EAA;EM 6000;EB 1;EP 300", 100)]
    [InlineData("EAA;EM 6000;EB 1;DPA=0", 100)]
    [InlineData("EAA;EM 6000;EB 1;EG 0", 46)]
    [InlineData("EAA;EM 6000;EB 1;EG ,-1;EG ,-1", 104)]
    [InlineData("EAA;EM 6000;EB 1;EG ,-1;PRB=10;BGB", 104)]
    [InlineData("EAA;EM 6000;EB 1;EG ,-1;DPB=0", 104)]
    [InlineData("EAA;EM 6000;EB 1;PRB=90000;BGB;EG ,-1", 7)]
    public async Task What_does_not_fit_the_cam_is_told_by_its_code(string line, int code)
    {
        await using var rig = new SimulatorRig();

        var reply = rig.Ask(line);

        Assert.Equal(new string(':', reply.Length - 1) + "?", reply);
        Assert.Equal($" {code}\r\n:", rig.Ask("TC"));
    }

    [Theory]
    [InlineData("EM ?,?", " 6000, 1500\r\n:")]
    [InlineData("EMB=?", " 1500\r\n:")]
    [InlineData("ET[2]=,?", " 2250\r\n:")]
    [InlineData("EP ?", " 2000\r\n:")]
    [InlineData("EB ?", " 0\r\n:")]
    [InlineData("EC ?", " 0\r\n:")]
    [InlineData("MG _EMA,_EMB,_EB", " 6000.0000 1500.0000 0.0000\r\n:")]
    public async Task The_cam_is_read_back(string query, string reply)
    {
        await using var rig = new SimulatorRig();

        Assert.Equal(reply, rig.Do(Table).Ask(query));
    }
}
