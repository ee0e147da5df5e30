using System.Globalization;

namespace Engraver.Core.Posts.Gcode;

/// <summary>The options of the G-code post.</summary>
internal sealed record GcodeChoice(GcodeDialect Dialect, string WorkOffset, string Switch, double SpindleSpeed, double Blend, string End)
{
    /// <summary>The spindle switch controls the tool, for example a laser or a pen.</summary>
    public const string BySpindle = "m3";

    /// <summary>The spindle switch counter-clockwise, by which a controller in laser mode makes the power proportional to the speed.</summary>
    public const string ByDynamicPower = "m4";

    /// <summary>The coolant switch controls the tool.</summary>
    public const string ByCoolant = "m8";

    /// <summary>A digital output controls the tool.</summary>
    public const string ByOutput = "m64";

    private static readonly string[] s_switches = [BySpindle, ByDynamicPower, ByCoolant, ByOutput];
    private static readonly string[] s_offsets = ["G54", "G55", "G56", "G57", "G58", "G59"];
    private static readonly string[] s_ends = ["m2", "m30"];

    public static PostOption DialectOption => new("dialect", "NAME", Wording.Get("GcodePost.Dialect"), GcodeDialect.LinuxCnc.Name, string.Join(" | ", GcodeDialect.All.Select(one => one.Name)), value => GcodeDialect.All.Any(one => one.Name == value));

    private static PostOption WorkOffsetOption => new("work-offset", "G", Wording.Get("GcodePost.WorkOffset"), s_offsets[0], Wording.Get("GcodePost.FromTo", s_offsets[0], s_offsets[^1]), value => s_offsets.Contains(value));

    private static PostOption SwitchOption => new("tool-switch", "CODE", Wording.Get("GcodePost.ToolSwitch"), BySpindle, string.Join(" | ", s_switches), value => s_switches.Contains(value));

    private static PostOption SpeedOption => new("spindle-speed", "S", Wording.Get("GcodePost.SpindleSpeed"), "1000", Wording.Get("GcodePost.NumberFromTo", "0", "1000000"), value => Number(value) is >= 0.0 and <= 1_000_000.0);

    public static PostOption BlendOption => new("blend", "MM", Wording.Get("GcodePost.Blend"), "0", Wording.Get("GcodePost.NumberFromTo", "0", "1"), value => Number(value) is >= 0.0 and <= 1.0);

    private static PostOption EndOption => new("program-end", "CODE", Wording.Get("GcodePost.ProgramEnd"), s_ends[0], string.Join(" | ", s_ends), value => s_ends.Contains(value));

    public static IReadOnlyList<PostOption> Options => [DialectOption, WorkOffsetOption, SwitchOption, SpeedOption, BlendOption, EndOption];

    public static GcodeChoice Of(PostRequest request) => new(GcodeDialect.Find(request.Value(DialectOption)), request.Value(WorkOffsetOption), request.Value(SwitchOption), Number(request.Value(SpeedOption))!.Value, Number(request.Value(BlendOption))!.Value, request.Value(EndOption));

    /// <summary>The switch of the tool has an S word.</summary>
    public bool HasSpeed => Switch is BySpindle or ByDynamicPower;

    private static double? Number(string text) => double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var number) && double.IsFinite(number) ? number : null;
}
