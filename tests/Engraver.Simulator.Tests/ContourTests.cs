using System.Text;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Simulator.Tests;

/// <summary>Contour mode (galil-dmc.md C.4, A.8 codes 18, 39, 41 and 42, A.10).</summary>
public class ContourTests
{
    private static readonly SimulatorOptions Newer = new() { ContourRecords = 511 };

    [Fact]
    public async Task Increments_are_straight_lines_over_their_intervals()
    {
        await using var rig = new SimulatorRig();
        rig.Run("CMA\nDT 2\nCD 48;WC\nDT 3\nCD 240;WC\nDT 4\nCD 48;WC\nDT0;CD0\nEN");

        var places = rig.Controller.Record.Snapshot().Select(s => s.A).SkipWhile(a => a == 0).ToList();

        Assert.Equal([12, 24, 36, 48, 78, 108, 138, 168, 198, 228, 258, 288, 291, 294], places.Take(14));
        Assert.Equal((336, 336, 51, 0), (rig.Value("_RPA"), rig.Value("_TPA"), rig.Value("_SCA"), rig.Value("_TC")));
    }

    [Fact]
    public async Task CD_0_with_interval_0_ends_the_mode_and_the_buffer_tells_its_room()
    {
        await using var rig = new SimulatorRig(Newer);
        rig.Do("CM AB", "DT 8", "CD 200,-350", "CD 100,200=4", "CD ,7", "CD 0,0=0");
        Assert.Equal(508, rig.Value("_CM"));
        Assert.Equal((50, 50, 1), (rig.Value("_SCA"), rig.Value("_SCB"), rig.Value("_BGA")));

        rig.RunToIdle();

        Assert.Equal((300, -143, 511), (rig.Value("_RPA"), rig.Value("_RPB"), rig.Value("_CM")));
        Assert.Equal((51, 51, 0), (rig.Value("_SCA"), rig.Value("_SCB"), rig.Value("_BGA")));
    }

    [Property]
    public Property A_contour_takes_the_sum_of_its_intervals_and_goes_the_sum_of_its_increments()
    {
        var records = Gen.Choose(-900, 900).Zip(Gen.Choose(1, 6)).ArrayOf(12);
        return Prop.ForAll(records.ToArbitrary(), contour =>
        {
            var rig = new SimulatorRig(Newer with { CommandCost = TimeSpan.Zero });
            rig.Do("CMA");
            foreach (var (increment, exponent) in contour) rig.Do($"CD {increment}={exponent}");
            rig.Do("CD 0=0");
            var start = rig.Controller.Status.Sample;
            rig.RunToIdle();
            return rig.Value("_RPA") == contour.Sum(r => r.Item1) && rig.Controller.Status.Sample - start == contour.Sum(r => 1 << r.Item2);
        });
    }

    [Fact]
    public async Task One_record_waits_behind_the_executing_one_and_a_further_one_is_refused()
    {
        await using var rig = new SimulatorRig();
        rig.Do("CMA", "DT 8", "CD 100").Pass(5);
        Assert.Equal(1, rig.Value("_CM"));

        rig.Do("CD 100");

        Assert.Equal(" 0\r\n:", rig.Ask("CM ?"));
        Assert.Equal(32, rig.Refusal("CD 100"));
    }

    [Fact]
    public async Task A_late_record_finds_the_axes_standing_and_code_42()
    {
        await using var rig = new SimulatorRig();
        rig.Do("CMA", "DT 1", "CD 100").Pass(50);
        Assert.Equal((100, 42, 50, 0), (rig.Value("_RPA"), rig.Value("_TC"), rig.Value("_SCA"), rig.Value("_BGA")));
        Assert.Equal(0x21, int.Parse(rig.Ask("TB")[..^3], System.Globalization.CultureInfo.InvariantCulture));

        rig.Do("CD 60", "DT 0", "CD 0").RunToIdle();

        Assert.Equal((160, 51), (rig.Value("_RPA"), rig.Value("_SCA")));
    }

    [Fact]
    public async Task At_max_a_begun_contour_waits_for_its_host()
    {
        await using var rig = new SimulatorRig();
        rig.Do("CMA", "DT 8", "CD 1000", "CD 1000");

        rig.Time.Advance(TimeSpan.FromSeconds(1.9));
        Assert.InRange(rig.Value("_RPA"), 1, 100);

        rig.Time.Advance(TimeSpan.FromSeconds(4.2));
        Assert.Equal(2000, rig.Value("_RPA"));
    }

    [Theory]
    [InlineData("STA", 4)]
    [InlineData("AB 1", 7)]
    public async Task A_stop_ends_the_mode_where_the_axes_are(string stop, int code)
    {
        await using var rig = new SimulatorRig();
        rig.Do("CMAB", "DT 8", "CD 1000,500", "CD 1000,500").Pass(50).Do(stop);
        var place = rig.Value("_RPA");

        Assert.InRange(place, 100, 600);
        Assert.Equal((place, code, code, 1), (rig.Pass(600).Value("_RPA"), rig.Value("_SCA"), rig.Value("_SCB"), rig.Value("_CM")));
    }

    [Fact]
    public async Task A_limit_ends_the_contour_of_all_its_axes()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { Switches = [new AxisSwitches(1) { ForwardLimitAt = 200 }] });

        rig.Do("CMAB", "DT 8", "CD 1000,500").RunToIdle();

        Assert.Equal((2, 2, 0), (rig.Value("_SCA"), rig.Value("_SCB"), rig.Value("_BGA")));
        Assert.InRange(rig.Value("_RPB"), 200, 204);
    }

    [Fact]
    public async Task The_record_shows_the_mode_the_direction_and_the_speed()
    {
        await using var rig = new SimulatorRig();
        rig.Do("CMA", "DT 8", "CD -5120").Pass(50);

        var record = Encoding.Latin1.GetBytes(rig.Ask("QR"));

        Assert.Equal(0x80C0, BitConverter.ToUInt16(record, 44));
        Assert.Equal(50, record[47]);
        Assert.Equal(-20000 * 64, BitConverter.ToInt32(record, 44 + 20));
        Assert.Equal(-20000, rig.Value("_TVA"));
    }

    [Fact]
    public async Task Intervals_count_samples_of_TM()
    {
        await using var rig = new SimulatorRig(new SimulatorOptions { CommandCost = TimeSpan.Zero });

        rig.Do("TM 500", "CMA", "DT 8", "CD 512").Pass(64);

        Assert.Equal(256, rig.Value("_RPA"));
    }

    [Fact]
    public async Task A_trajectory_that_was_recorded_is_played_again()
    {
        await using var rig = new SimulatorRig();
        rig.Do("DM px[33],dx[33]", "RA px[]", "RD _TPA");
        rig.Run("#TEACH\nRC 3,33\nPRA=3000\nBGA\n#W\nJP#W,_RC=1\nEN");
        rig.Run("i=0\n#D\ndx[i]=px[i+1]-px[i]\ni=i+1\nJP#D,i<32\nEN");
        var taught = rig.Value("px[32]-px[0]");
        Assert.InRange(taught, 2500, 3000);

        rig.Do("PAA=0", "BGA").RunToIdle();
        rig.Run("CMA\nDT 3;i=0\n#P\nCD dx[i];WC\ni=i+1;JP#P,i<32\nDT0;CD0\nEN");

        Assert.Equal((taught, 0), (rig.Value("_RPA"), rig.Value("_TC")));
    }

    [Theory]
    [InlineData("CD 5", 8)]
    [InlineData("WC", 2)]
    [InlineData("CMA;CD 5", 39)]
    [InlineData("CMA;DT 9", 6)]
    [InlineData("CMA;DT 2;CD 32001", 41)]
    [InlineData("CMA;DT 2;CD ,5", 90)]
    [InlineData("CMA;DT 2;CD", 50)]
    [InlineData("CMA;CMB", 18)]
    [InlineData("CMA;PRA=10;BGA", 18)]
    [InlineData("CMA;VMAB;VP 5,5;VE;BGS", 18)]
    [InlineData("CMA;DPA=5", 18)]
    [InlineData("CMN", 90)]
    [InlineData("CMA=1", 4)]
    [InlineData("MOA;CMA", 20)]
    [InlineData("PRA=9000;BGA;CMA", 7)]
    public async Task What_does_not_fit_a_contour_is_told_by_its_code(string line, int code)
    {
        await using var rig = new SimulatorRig();

        var reply = rig.Ask(line);

        Assert.Equal(new string(':', reply.Length - 1) + "?", reply);
        Assert.Equal($" {code}\r\n:", rig.Ask("TC"));
    }
}
