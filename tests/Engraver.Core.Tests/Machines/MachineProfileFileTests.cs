using Engraver.Core.Machines;

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
