using System.Globalization;
using System.Text;

namespace Engraver.Workbench.Settings;

/// <summary>Every setting between a drawing and its motion.</summary>
public static class SettingTable
{
    private static readonly DrawingSettings s_defaults = new();

    public static SettingDescription Layers { get; } = new("layers")
    {
        Flag = "--layers", Argument = "A,B", Command = "LAYER"
    };

    public static SettingDescription SkippedLayers { get; } = new("skip-layers") { Flag = "--skip-layers", Argument = "A,B", Command = "LAYER" };

    public static SettingDescription Units { get; } = new("units")
    {
        Flag = "--units", Argument = "mm|inch|auto", Command = "CNCUNITS", Least = 0, Most = 24, Whole = true
    };

    public static SettingDescription Cut { get; } = new("cut")
    {
        Flag = "--cut", Argument = "hatch,mline,leader,helix,solid", Command = "CNCCUT", Least = 0, Most = 31, Whole = true
    };

    public static SettingDescription JoinTolerance { get; } = new("join-tolerance")
    {
        Unit = "mm", Flag = "--join-tolerance", Argument = "MM", Command = "CNCJOINTOL", Least = 0.0, Most = 1e3, Default = Number(s_defaults.JoinToleranceMm),
    };

    public static SettingDescription MaxError { get; } = new("max-error")
    {
        Unit = "mm", Flag = "--max-error", Argument = "MM", Command = "CNCMAXERR", Least = 1e-9, Most = 1e3, Default = Number(s_defaults.MaxErrorMm),
    };

    public static SettingDescription Start { get; } = new("start") { Unit = "mm", Flag = "--start", Argument = "X,Y", Command = "TOOLSTART", Default = "0,0" };

    public static SettingDescription Finish { get; } = new("finish") { Flag = "--finish", Argument = "origin|stay|park", Command = "CNCFINISH", Default = "origin" };

    public static SettingDescription Enter { get; } = new("enter") { Flag = "--enter", Argument = "HANDLE|X,Y", Command = "ENTER" };

    public static SettingDescription Order { get; } = new("order")
    {
        Flag = "--order", Argument = "drawn|nearest", Command = "CNCORDER", Default = "nearest",
    };

    public static SettingDescription KeepDuplicates { get; } = new("keep-duplicates")
    {
        Flag = "--keep-duplicates", Command = "CNCDUPLICATES", Least = 0, Most = 1, Whole = true, Default = "0",
    };

    public static SettingDescription RecoverArcs { get; } = new("recover-arcs")
    {
        Flag = "--recover-arcs", Command = "CNCRECOVER", Least = 0, Most = 1, Whole = true, Default = "0",
    };

    public static SettingDescription Kerf { get; } = new("kerf") { Flag = "--kerf", Argument = "off|nesting|outside|inside|left|right", Command = "KERF", Default = "off" };

    public static SettingDescription ToolDiameter { get; } = new("tool-diameter") { Unit = "mm", Flag = "--tool-diameter", Argument = "MM", Command = "KERF", Least = 1e-3, Most = 1e3 };

    public static SettingDescription Machine { get; } = new("machine") { Flag = "--machine", Argument = "PROFILE.json", Command = "CNCPROFILE" };

    public static SettingDescription Feed { get; } = new("feed")
    {
        Unit = "mm/min", Flag = "--feed", Argument = "MM/MIN", Command = "CNCFEED", Least = 1e-6, Most = 1e9, JsonField = "feedMmPerMinute", Default = Number(s_defaults.Machine.FeedMmPerMinute),
    };

    public static SettingDescription VectorSpeed { get; } = new("vector-speed") { Unit = "counts/s", Command = "CNCVS", Least = 1e-3, Most = 1e12 };

    public static SettingDescription Rapid { get; } = new("rapid")
    {
        Unit = "mm/min", Command = "CNCRAPID", Least = 1e-6, Most = 1e9, JsonField = "rapidMmPerMinute", Default = Number(s_defaults.Machine.RapidMmPerMinute),
    };

    public static SettingDescription Acceleration { get; } = new("acceleration")
    {
        Unit = "counts/s2", Command = "CNCVA", Least = 1024, Most = 67107840, Whole = true, JsonField = "accelerationCounts", Default = Number(s_defaults.Machine.AccelerationCounts),
    };

    public static IReadOnlyList<SettingDescription> All { get; } =
        [Layers, SkippedLayers, Units, Cut, JoinTolerance, MaxError, Start, Finish, Enter, Order, KeepDuplicates, RecoverArcs, Kerf, ToolDiameter, Machine, Feed, VectorSpeed, Rapid, Acceleration];

    /// <summary>The text of docs/settings.md.</summary>
    public static string ToMarkdown()
    {
        var page = new StringBuilder("# Settings\n\nThis page is generated from the program's own table (`./test --update-golden`).\nMessages name a setting by its key in brackets; the console shows its option there, the desktop its command.\n\n");
        page.Append("| Key | Setting | Unit | Default | Option | Command | Range of the command | JSON | Meaning |\n|---|---|---|---|---|---|---|---|---|\n");
        foreach (var setting in All)
        {
            page.Append("| ").AppendJoin(" | ", setting.Key, setting.Name, setting.Unit, setting.Default, Code(Option(setting)), Code(setting.Command), Range(setting), Code(setting.JsonField), setting.Meaning).Append(" |\n");
        }

        return page.ToString();
    }

    private static string Option(SettingDescription setting) => setting.Argument is { } argument ? $"{setting.Flag} {argument}".Trim() : setting.Flag ?? "";

    private static string Range(SettingDescription setting) => setting.Most > setting.Least ? $"{Number(setting.Least)} to {Number(setting.Most)}" : "";

    private static string Code(string? text) => string.IsNullOrEmpty(text) ? "" : $"`{text.Replace("|", "\\|", StringComparison.Ordinal)}`";

    private static string Number(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
