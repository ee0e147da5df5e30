using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Profiles;

namespace Engraver.Core.Tests.Machines;

public class MachineProfileFileTests
{
    /// <summary>Limits of the DMC-21x3.</summary>
    private static readonly MachineLimits s_limits = new(SlowestSpeed: 2, FastestSpeed: 12_000_000, AccelerationStep: 1024, LargestAcceleration: 67_107_840, Outputs: 8, "ABCDEFGH");

    /// <summary>All errors of a file are reported at once: a misspelt name does not hide the others, and consequences of other errors are not
    /// reported.</summary>
    [Fact]
    public void Everything_that_is_wrong_is_told_at_once_and_nothing_that_nobody_wrote()
    {
        var both = MachineProfileFile.Read("{\n \"feedMmPerMinut\": 600,\n \"toolOutput\": 9,\n \"accelerationCounts\": 3 }", s_limits);
        var unread = MachineProfileFile.Read("{\n \"feedMmPerMinut\": 600,\n \"toolOutput\": \"nine\" }", s_limits);
        var slow = MachineProfileFile.Read("{\n \"rapidMmPerMinute\": 0 }", s_limits);
        var drive = MachineProfileFile.Read("{\n \"toolDriv\": \"axis\",\n \"cutDepth\": 1 }", s_limits);

        Assert.Null(both.Profile);
        Assert.Equal([(2L, "feedMmPerMinut"), (4L, "accelerationCounts"), (3L, "toolOutput")], both.Diagnostics.Select(finding => (finding.Source.Line, finding.Facts[0])));
        Assert.Equal([(2L, "feedMmPerMinut"), (3L, "toolOutput")], unread.Diagnostics.Select(finding => (finding.Source.Line, finding.Facts[0])));
        Assert.Equal(["rapidMmPerMinute"], slow.Diagnostics.Select(finding => finding.Facts[0]));
        Assert.Equal(["toolDriv"], drive.Diagnostics.Select(finding => finding.Facts[0]));
    }

    [Fact]
    public void An_empty_object_is_the_default_machine_profile() => Assert.Equal(MachineProfile.Default, MachineProfileFile.Read("{}", s_limits).Profile);

    [Fact]
    public void The_default_profile_is_the_one_of_the_contract()
    {
        var profile = MachineProfile.Default;

        Assert.Equal((MachineAxes.FromScale(1000.0, 1000.0), 256000), (profile.Axes, profile.AccelerationCounts));
        Assert.Equal((1, 0.1, 1.0 / 65536.0), (profile.ToolOutput, profile.ToolSettleSeconds, profile.AngleQuantumDegrees));
    }

    [Fact]
    public void What_is_written_is_read_back()
    {
        var profile = new MachineProfile
        {
            Axes = new MachineAxes(new MachineAxis('C', -80.5), new MachineAxis('A', 81.25)), FeedMmPerMinute = 601, RapidMmPerMinute = 2999, AccelerationCounts = 102400,
            AccelerationX = 51200, AccelerationY = 20480, ToolOutput = 3, ToolSettleSeconds = 0.25, AngleQuantumDegrees = 1.0 / 256.0,
        };

        Assert.Equal(profile, MachineProfileFile.Read(MachineProfileFile.Write(profile), s_limits).Profile);
    }

    /// <summary>Files of earlier versions have the field; it is reported, and does not keep the file from being read.</summary>
    [Fact]
    public void The_angle_of_sharp_corners_is_ignored_and_told()
    {
        var read = MachineProfileFile.Read("{ \"sharpCornerDegrees\": 20 }", s_limits);

        Assert.Equal(MachineProfile.Default, read.Profile);
        Assert.Equal(("MOT0026", "sharpCornerDegrees", 1), (Assert.Single(read.Diagnostics).Id, read.Diagnostics[0].Facts[0], read.Diagnostics[0].Source.Line));
        Assert.DoesNotContain("sharpCorner", MachineProfileFile.Write(MachineProfile.Default), StringComparison.Ordinal);
    }

    [Fact]
    public void A_machine_has_a_Z_axis_when_its_profile_names_letter_and_counts()
    {
        var read = MachineProfileFile.Read("{ \"axisZ\": \"C\", \"countsPerMillimetreZ\": -400 }", s_limits).Profile!;

        Assert.Equal(("ABC", "AB", -400.0), (read.Axes.Letters, read.Axes.PlaneLetters, read.Scale.Z.CountsPerMillimetre));
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
            Axes = axes, JogMmPerMinute = 120, Inputs = new IoLineNames([KeyValuePair.Create(3, "door")]), Outputs = new IoLineNames([KeyValuePair.Create(1, "laser"), KeyValuePair.Create(2, "fan")]),
        };

        Assert.Equal(profile, MachineProfileFile.Read(MachineProfileFile.Write(profile), s_limits).Profile);
        Assert.NotEqual(profile, profile with { Inputs = new IoLineNames([KeyValuePair.Create(3, "lid")]) });
    }

    [Theory]
    [InlineData("\"travelX\": { \"min\": 5, \"max\": 5 }", "travelX to 5..5")]
    [InlineData("\"travelY\": { \"min\": 5 }", "travelY to 5..NaN")]
    [InlineData("\"travelY\": { \"min\": 5, \"most\": 7 }", "field travelY.most")]
    [InlineData("\"travelY\": { \"min\": 5, \"max\": \"7\" }", "value of travelY.max in the machine profile is not a valid number")]
    [InlineData("\"homing\": [{ \"axis\": \"W\", \"by\": \"switch\", \"direction\": \"plus\" }]", "homing.axis to W")]
    [InlineData("\"homing\": [{ \"axis\": \"X\", \"by\": \"switch\", \"direction\": \"plus\" }, { \"axis\": \"X\", \"by\": \"limit\", \"direction\": \"plus\" }]", "homing.axis to X")]
    [InlineData("\"homing\": [{ \"axis\": \"X\", \"by\": \"luck\", \"direction\": \"plus\" }]", "homing.X.by")]
    [InlineData("\"homing\": [{ \"axis\": \"X\", \"by\": \"switch\" }]", "homing.X.direction")]
    [InlineData("\"homing\": [{ \"axis\": \"X\", \"by\": \"switch\", \"direction\": \"plus\", \"slowMmPerMinute\": 601 }]", "homing.X.slowMmPerMinute to 601; required: at most fastMmPerMinute")]
    [InlineData("\"homing\": [{ \"axis\": \"Y\", \"by\": \"switch\", \"direction\": \"plus\", \"backOff\": -1 }]", "homing.Y.backOff to -1")]
    [InlineData("\"homing\": [{ \"axis\": \"Y\", \"by\": \"switch\", \"direction\": \"minus\", \"zero\": -5 }], \"travelY\": { \"min\": 0, \"max\": 100 }", "it ends at -3 mm")]
    [InlineData("\"homing\": [{ \"axis\": \"Y\", \"by\": \"switch\", \"direction\": \"plus\", \"seconds\": 0 }]", "homing.Y.seconds to 0")]
    [InlineData("\"inputs\": { \"9\": \"door\" }", "inputs.9 to door")]
    [InlineData("\"outputs\": { \"1\": \"a fan\" }", "outputs.1 to a fan")]
    [InlineData("\"outputs\": { \"1\": \"fan\", \"2\": \"FAN\" }", "outputs.2 to FAN")]
    [InlineData("\"outputs\": { \"1\": 7 }", "value of outputs.1 in the machine profile is not a valid number")]
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
    [InlineData("{\n \"feed\": 1 }", "MOT0009", 2, "unknown field feed; the nearest known name is feedMmPerMinute")]
    [InlineData("{\n \"ToolOuput\": 1 }", "MOT0009", 2, "nearest known name is toolOutput")]
    [InlineData("{\n \"colour\": 1 }", "MOT0009", 2, "unknown field colour; no known name is similar")]
    [InlineData("{\n \"travelX\": {\n \"minimum\": 1 } }", "MOT0009", 3, "unknown field travelX.minimum; the nearest known name is min")]
    [InlineData("{\n \"homing\": [ {}, {\n \"axes\": \"X\" } ] }", "MOT0009", 3, "unknown field homing[1].axes; the nearest known name is axis")]
    [InlineData("{ \"a.b\": 1 }", "MOT0009", 1, "field a.b")]
    [InlineData("{\n \"costPerHour\": -1 }", "MOT0006", 2, "costPerHour to -1; required: 0 to")]
    [InlineData("{\n\n \"toolOutput\": \"one\" }", "MOT0010", 3, "toolOutput")]
    [InlineData("{\n \"toolOutput\": 1.5 }", "MOT0010", 2, "toolOutput")]
    [InlineData("{\n \"toolOutput\": 1,\n \"toolOutput\": 2 }", "MOT0010", 3, "toolOutput")]
    [InlineData("{\n \"toolOutput\": 1", "MOT0008", 2, "JSON")]
    [InlineData("", "MOT0008", 1, "JSON")]
    [InlineData("null", "MOT0008", 1, "null")]
    [InlineData("[1]", "MOT0008", 1, "object")]
    [InlineData("{ \"toolOutput\": 9 }", "MOT0006", 1, "toolOutput to 9")]
    [InlineData("{ \"accelerationCounts\": 100000 }", "MOT0006", 1, "accelerationCounts to 100000; required: a multiple of 1024")]
    [InlineData("{ \"feedMmPerMinute\": 0 }", "MOT0006", 1, "feedMmPerMinute to 0")]
    [InlineData("{ \"rapidMmPerMinute\": 720001 }", "MOT0006", 1, "12000000")]
    [InlineData("{ \"countsPerMillimetreX\": 0 }", "MOT0006", 1, "countsPerMillimetreX to 0")]
    [InlineData("{ \"axisX\": \"Q\" }", "MOT0006", 1, "axisX to Q; required: one of the letters ABCDEFGH")]
    [InlineData("{ \"axisY\": \"b\" }", "MOT0006", 1, "axisY to b")]
    [InlineData("{ \"axisY\": \"BC\" }", "MOT0006", 1, "axisY to a value that is not one letter")]
    [InlineData("{ \"axisY\": \"\" }", "MOT0006", 1, "axisY to a value that is not one letter")]
    [InlineData("{ \"axisX\": \"B\" }", "MOT0006", 0, "axisY to B; required: an axis other than axisX")]
    [InlineData("{ \"axisZ\": \"B\", \"countsPerMillimetreZ\": 400 }", "MOT0006", 1, "axisZ to B; required: an axis other than axisY")]
    [InlineData("{ \"axisZ\": \"C\" }", "MOT0006", 0, "countsPerMillimetreZ to 0")]
    [InlineData("{ \"countsPerMillimetreZ\": 400 }", "MOT0006", 0, "axisZ to a value that is not one letter")]
    [InlineData("{ \"accelerationX\": 100 }", "MOT0006", 1, "accelerationX to 100")]
    [InlineData("{ \"toolSettleSeconds\": 1e9 }", "MOT0006", 1, "toolSettleSeconds")]
    [InlineData("{ \"angleQuantumDegrees\": 0 }", "MOT0006", 1, "angleQuantumDegrees to 0")]
    public void What_is_wrong_is_said_with_its_line_and_its_field(string json, string id, long line, string says)
    {
        var read = MachineProfileFile.Read(json, s_limits);

        Assert.Null(read.Profile);
        var finding = read.Diagnostics[0];
        Assert.Equal((id, line), (finding.Id, finding.Source.Line));
        Assert.Contains(says, finding.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Every_field_that_does_not_exist_is_told_and_not_only_the_first()
    {
        var read = MachineProfileFile.Read("{\n \"feed\": 1,\n \"inputs\": { \"2\": \"lid\" },\n \"rapid\": 2\n}", s_limits);

        Assert.Null(read.Profile);
        Assert.Equal([("MOT0009", 2L, "feed"), ("MOT0009", 4L, "rapid")], read.Diagnostics.Select(finding => (finding.Id, finding.Source.Line, finding.Facts[0])));
    }

    [Theory]
    [InlineData("\"rapidMmPerMinute\": 200", "rapidMmPerMinute to 200, but feedMmPerMinute is 1200")]
    [InlineData("\"jogMmPerMinute\": 3001", "jogMmPerMinute to 3001, but rapidMmPerMinute is 3000")]
    [InlineData("\"parkX\": 5, \"parkY\": 7, \"travelX\": { \"min\": 6, \"max\": 9 }", "parkX to 5, but travelX is 6 to 9")]
    [InlineData("\"axisZ\": \"C\", \"countsPerMillimetreZ\": 400, \"toolDrive\": \"axis\", \"plungeMmPerMinute\": 3001", "plungeMmPerMinute to 3001, but rapidMmPerMinute is 3000")]
    [InlineData("\"axisZ\": \"C\", \"countsPerMillimetreZ\": 400, \"toolDrive\": \"axis\", \"cutDepth\": 7, \"travelZ\": { \"min\": -6, \"max\": 5.5 }", "clearanceHeight to 5, but cutDepth is 7 and travelZ is -6 to 5.5")]
    public void Settings_that_contradict_each_other_are_warned_of_and_the_profile_can_be_used(string fields, string sentence)
    {
        var read = MachineProfileFile.Read("{ " + fields + " }", s_limits);

        Assert.NotNull(read.Profile);
        var finding = Assert.Single(read.Diagnostics);
        Assert.Equal(("MOT0023", Severity.Warning), (finding.Id, finding.Severity));
        Assert.Contains(sentence, finding.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_clearance_height_below_the_retract_height_or_a_depth_above_the_work_is_no_profile()
    {
        const string Mill = "{ \"axisZ\": \"C\", \"countsPerMillimetreZ\": 400, \"toolDrive\": \"axis\",\n";

        Assert.Contains("clearanceHeight to 0.5; required: at least retractHeight, 1", Assert.Single(MachineProfileFile.Read(Mill + "\"clearanceHeight\": 0.5 }", s_limits).Diagnostics).Message, StringComparison.Ordinal);
        Assert.Contains("cutDepth to -2; required: 0 or more", Assert.Single(MachineProfileFile.Read(Mill + "\"cutDepth\": -2 }", s_limits).Diagnostics).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Rates_are_written_and_read_back_and_a_profile_without_any_has_none()
    {
        var profile = MachineProfile.Default with { Rates = new JobRates(60, 2.5, 0.25) };

        Assert.Equal(profile, MachineProfileFile.Read(MachineProfileFile.Write(profile), s_limits).Profile);
        Assert.Equal(new JobRates(0, 3), MachineProfileFile.Read("{ \"costPerMetre\": 3 }", s_limits).Profile!.Rates);
        Assert.Null(MachineProfileFile.Read("{}", s_limits).Profile!.Rates);
    }

    [Fact]
    public void The_meaning_of_a_profile_names_its_numbers_and_what_they_come_to()
    {
        var profile = MachineProfile.Default with
        {
            Axes = new MachineAxes(new MachineAxis('C', -80.0) { Travel = new AxisTravel(0, 300), Homing = new AxisHoming { Plus = false, Zero = -1 } }, new MachineAxis('A', 160.0)),
            AccelerationCounts = 40960, Rates = new JobRates(60, 2.5), ToolActiveLow = true, Outputs = new IoLineNames([KeyValuePair.Create(3, "air")]),
        };
        var meaning = ProfileMeaning.Of(profile);

        Assert.Contains("X is axis C of the controller, mirrored: 80 counts per millimetre; one count is 0.0125 mm (0.0004921 inch).", meaning);
        Assert.Contains("The travel of X is 0 to 300 mm (machine position).", meaning);
        Assert.Contains("Y has no soft limits.", meaning);
        Assert.Contains("X and Y have different counts per millimetre: arcs are cut as chords.", meaning);
        Assert.Contains("The acceleration is 256 mm/s2: the feed is reached after 0.078 s and 0.781 mm.", meaning);
        Assert.Contains("The tool is on while output 1 is off; the machine waits 0.1 s after switching it on and 0.1 s after switching it off.", meaning);
        Assert.Contains("X is homed to the home switch, in the negative direction at 600 mm/min; the machine position there is -1 mm.", meaning);
        Assert.Contains("Named outputs: 3 = air.", meaning);
        Assert.Contains("Costs: 60 per hour, 2.5 per metre of cut, 0 per start.", meaning);
    }
}
