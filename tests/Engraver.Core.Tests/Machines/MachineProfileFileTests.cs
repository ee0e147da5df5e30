using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;

namespace Engraver.Core.Tests.Machines;

public class MachineProfileFileTests
{
    /// <summary>As of the DMC-21x3.</summary>
    private static readonly MachineLimits s_limits = new(SlowestSpeed: 2, FastestSpeed: 12_000_000, AccelerationStep: 1024, LargestAcceleration: 67_107_840, Outputs: 8, "ABCDEFGH");

    [Fact]
    public void An_empty_object_is_the_default_machine_profile() => Assert.Equal(MachineProfile.Default, MachineProfileFile.Read("{}", s_limits).Profile);

    [Fact]
    public void The_default_profile_is_the_one_of_the_contract()
    {
        var profile = MachineProfile.Default;

        Assert.Equal((MachineAxes.FromScale(1000.0, 1000.0), 256000), (profile.Axes, profile.AccelerationCounts));
        Assert.Equal((1, 0.1, 10.0, 1.0 / 65536.0), (profile.ToolOutput, profile.ToolSettleSeconds, profile.SharpCornerDegrees, profile.AngleQuantumDegrees));
    }

    [Fact]
    public void What_is_written_is_read_back()
    {
        var profile = new MachineProfile
        {
            Axes = new MachineAxes(new MachineAxis('C', -80.5), new MachineAxis('A', 81.25)), FeedMmPerMinute = 601, RapidMmPerMinute = 2999, AccelerationCounts = 102400,
            SharpCornerDegrees = 12.5, ToolOutput = 3, ToolSettleSeconds = 0.25, AngleQuantumDegrees = 1.0 / 256.0,
        };

        Assert.Equal(profile, MachineProfileFile.Read(MachineProfileFile.Write(profile), s_limits).Profile);
    }

    [Fact]
    public void A_machine_has_a_Z_axis_when_its_profile_names_letter_and_counts()
    {
        var read = MachineProfileFile.Read("{ \"axisZ\": \"C\", \"countsPerMillimetreZ\": -400 }", s_limits).Profile!;

        Assert.Equal(("ABC", "AB", -400.0), (read.Axes.Letters, read.Axes.PlaneLetters, read.Scale.Z));
        Assert.Equal((-1000, 2.5), (read.Scale.ToHeight(2.5), read.Scale.ToMillimetres(-1000)));
        Assert.Equal(read, MachineProfileFile.Read(MachineProfileFile.Write(read), s_limits).Profile);
        Assert.Null(MachineProfile.Default.Axes.Z);
        Assert.Equal((0, 0.0), (MachineProfile.Default.Scale.ToHeight(2.5), MachineProfile.Default.Scale.ToMillimetres(-1000)));
    }

    [Fact]
    public void Travel_homing_and_names_of_lines_are_written_and_read_back_and_homing_keeps_its_order()
    {
        var y = new AxisHoming { By = HomingMark.LimitIndex, Plus = true, FastMmPerMinute = 300, SlowMmPerMinute = 20, BackOff = 0.5, Zero = 199, Seconds = 30 };
        var axes = new MachineAxes(
            new MachineAxis('A', 1000) { Travel = new AxisTravel(-3, 300.5), Homing = new AxisHoming { Order = 1 } },
            new MachineAxis('B', -1000) { Travel = new AxisTravel(0, 200), Homing = y });
        var profile = MachineProfile.Default with
        {
            Axes = axes, JogMmPerMinute = 120, Inputs = new LineNames([KeyValuePair.Create(3, "door")]), Outputs = new LineNames([KeyValuePair.Create(1, "laser"), KeyValuePair.Create(2, "fan")]),
        };

        Assert.Equal(profile, MachineProfileFile.Read(MachineProfileFile.Write(profile), s_limits).Profile);
        Assert.NotEqual(profile, profile with { Inputs = new LineNames([KeyValuePair.Create(3, "lid")]) });
    }

    [Theory]
    [InlineData("\"travelX\": { \"min\": 5, \"max\": 5 }", "travelX to 5..5")]
    [InlineData("\"travelY\": { \"min\": 5 }", "travelY to 5..NaN")]
    [InlineData("\"travelY\": { \"min\": 5, \"most\": 7 }", "field travelY.most")]
    [InlineData("\"travelY\": { \"min\": 5, \"max\": \"7\" }", "travelY.max a value that is no number")]
    [InlineData("\"homing\": [{ \"axis\": \"W\", \"by\": \"switch\", \"direction\": \"plus\" }]", "homing.axis to W")]
    [InlineData("\"homing\": [{ \"axis\": \"X\", \"by\": \"switch\", \"direction\": \"plus\" }, { \"axis\": \"X\", \"by\": \"limit\", \"direction\": \"plus\" }]", "homing.axis to X")]
    [InlineData("\"homing\": [{ \"axis\": \"X\", \"by\": \"luck\", \"direction\": \"plus\" }]", "homing.X.by")]
    [InlineData("\"homing\": [{ \"axis\": \"X\", \"by\": \"switch\" }]", "homing.X.direction")]
    [InlineData("\"homing\": [{ \"axis\": \"X\", \"by\": \"switch\", \"direction\": \"plus\", \"slowMmPerMinute\": 601 }]", "homing.X.slowMmPerMinute to 601; it must be at most fastMmPerMinute")]
    [InlineData("\"homing\": [{ \"axis\": \"Y\", \"by\": \"switch\", \"direction\": \"plus\", \"backOff\": -1 }]", "homing.Y.backOff to -1")]
    [InlineData("\"homing\": [{ \"axis\": \"Y\", \"by\": \"switch\", \"direction\": \"minus\", \"zero\": -5 }], \"travelY\": { \"min\": 0, \"max\": 100 }", "it ends at -3 mm")]
    [InlineData("\"homing\": [{ \"axis\": \"Y\", \"by\": \"switch\", \"direction\": \"plus\", \"seconds\": 0 }]", "homing.Y.seconds to 0")]
    [InlineData("\"inputs\": { \"9\": \"door\" }", "inputs.9 to door")]
    [InlineData("\"outputs\": { \"1\": \"a fan\" }", "outputs.1 to a fan")]
    [InlineData("\"outputs\": { \"1\": \"fan\", \"2\": \"FAN\" }", "outputs.2 to FAN")]
    [InlineData("\"outputs\": { \"1\": 7 }", "outputs.1 a value")]
    [InlineData("\"jogMmPerMinute\": 0", "jogMmPerMinute to 0")]
    public void What_hand_moves_and_homing_go_by_is_checked_with_the_field_named(string fields, string sentence)
    {
        var read = MachineProfileFile.Read("{ " + fields + " }", s_limits);

        Assert.Null(read.Profile);
        Assert.Contains(read.Diagnostics, finding => finding.Message.Contains(sentence, StringComparison.Ordinal));
    }

    [Fact]
    public void A_machine_that_is_slow_is_jogged_no_faster_than_it_goes() =>
        Assert.Equal(200, MachineProfileFile.Read("{ \"rapidMmPerMinute\": 200 }", s_limits).Profile!.JogMmPerMinute);

    [Fact]
    public void Comments_and_trailing_commas_are_allowed()
    {
        var read = MachineProfileFile.Read("{ // the small machine\n \"feedMmPerMinute\": 600, /* slow */ \"toolOutput\": 2, }", s_limits);

        Assert.Equal(MachineProfile.Default with { FeedMmPerMinute = 600, ToolOutput = 2 }, read.Profile);
    }

    [Theory]
    [InlineData("{\n \"feed\": 1 }", "MOT0009", 2, "feed")]
    [InlineData("{\n\n \"toolOutput\": \"one\" }", "MOT0010", 3, "toolOutput")]
    [InlineData("{\n \"toolOutput\": 1.5 }", "MOT0010", 2, "toolOutput")]
    [InlineData("{\n \"toolOutput\": 1,\n \"toolOutput\": 2 }", "MOT0010", 3, "toolOutput")]
    [InlineData("{\n \"toolOutput\": 1", "MOT0008", 2, "JSON")]
    [InlineData("", "MOT0008", 1, "JSON")]
    [InlineData("null", "MOT0008", 1, "null")]
    [InlineData("[1]", "MOT0008", 1, "object")]
    [InlineData("{ \"toolOutput\": 9 }", "MOT0006", 0, "toolOutput to 9")]
    [InlineData("{ \"accelerationCounts\": 100000 }", "MOT0006", 0, "accelerationCounts to 100000; it must be a multiple of 1024")]
    [InlineData("{ \"feedMmPerMinute\": 0 }", "MOT0006", 0, "feedMmPerMinute to 0")]
    [InlineData("{ \"rapidMmPerMinute\": 720001 }", "MOT0006", 0, "12000000")]
    [InlineData("{ \"countsPerMillimetreX\": 0 }", "MOT0006", 0, "countsPerMillimetreX to 0")]
    [InlineData("{ \"axisX\": \"Q\" }", "MOT0006", 0, "axisX to Q; it must be one of the letters ABCDEFGH")]
    [InlineData("{ \"axisY\": \"b\" }", "MOT0006", 0, "axisY to b")]
    [InlineData("{ \"axisY\": \"BC\" }", "MOT0006", 0, "axisY to not one letter")]
    [InlineData("{ \"axisY\": \"\" }", "MOT0006", 0, "axisY to not one letter")]
    [InlineData("{ \"axisX\": \"B\" }", "MOT0006", 0, "axisY to B; it must be another axis than axisX")]
    [InlineData("{ \"axisZ\": \"B\", \"countsPerMillimetreZ\": 400 }", "MOT0006", 0, "axisZ to B; it must be another axis than axisY")]
    [InlineData("{ \"axisZ\": \"C\" }", "MOT0006", 0, "countsPerMillimetreZ to 0")]
    [InlineData("{ \"countsPerMillimetreZ\": 400 }", "MOT0006", 0, "axisZ to not one letter")]
    [InlineData("{ \"sharpCornerDegrees\": -1 }", "MOT0006", 0, "sharpCornerDegrees to -1")]
    [InlineData("{ \"toolSettleSeconds\": 1e9 }", "MOT0006", 0, "toolSettleSeconds")]
    [InlineData("{ \"angleQuantumDegrees\": 0 }", "MOT0006", 0, "angleQuantumDegrees to 0")]
    public void What_is_wrong_is_said_with_its_line_and_its_field(string json, string id, long line, string says)
    {
        var read = MachineProfileFile.Read(json, s_limits);

        Assert.Null(read.Profile);
        var finding = read.Diagnostics[0];
        Assert.Equal((id, line), (finding.Id, finding.Source.Line));
        Assert.Contains(says, finding.Message, StringComparison.Ordinal);
    }
}
