using System.Text;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Posts.Agie;
using Engraver.Core.Posts.AgieReading;
using Engraver.Core.Posts.ClDataReading;
using Engraver.Core.Posts.Gcode;
using Engraver.Core.Posts.GcodeReading;
using Engraver.Core.Posts.Hpgl;
using Engraver.Core.Posts.HpglReading;
using Engraver.Core.Trajectories.Formats;
using Engraver.Core.Trajectories.Posting;
using Engraver.Core.Trajectories.Reading;
using Engraver.Galil.Driver;
using Engraver.Galil.Programs.Posting;

namespace Engraver.Workbench.Composition;

/// <summary>The table of output formats, used by <c>post</c> and <c>verify</c> of the console, POST, EXPORT and docs/posts.md. A new format adds one
/// line.</summary>
public static class PostTable
{
    public static IReadOnlyList<PostEntry> All { get; } =
    [
        new(GalilPost.Sequences, "Galil", new DmcReader()) { Controller = GalilDriver.FamilyKey },
        new(GalilPost.Calls, "galil-Calls", new DmcReader()) { Controller = GalilDriver.FamilyKey },
        new(new ClDataPost(), "cLdata", new ClDataReader()),
        new(new AgiePost(), "Agie", new AgieReader()),
        new(new GcodePost(), "gcoDe", new GcodeReader()) { Dialects = new Dictionary<string, IProgramReader> { ["linuxcnc"] = new GcodeReader(GcodeController.LinuxCnc), ["grbl"] = new GcodeReader(GcodeController.Grbl) }, OtherDialects = new Dictionary<string, string> { ["gcode-gRbl"] = "grbl" } },
        new(new HpglPost(), "Hpgl", new HpglReader()),
        new(new XpsPost(TrajectoryFormat.XpsLineArc, "xps-linearc", ".xpslinearc"), "Xps-linearc", new TrajectoryReader(ControllerLanguage.LineArc)),
        new(new XpsPost(TrajectoryFormat.XpsSpline, "xps-spline", ".xpsspline"), "xps-Spline", new TrajectoryReader(ControllerLanguage.RelativeSpline)),
        new(new XpsPost(TrajectoryFormat.XpsPvt, "xps-pvt", ".xpspvt"), "xps-Pvt", new TrajectoryReader(ControllerLanguage.Pvt)),
    ];

    /// <summary>Every entry, once for each dialect.</summary>
    public static IReadOnlyList<PostChoice> Choices { get; } = [.. All.SelectMany(entry => entry.OtherDialects.Select(other => new PostChoice(other.Key, entry, other.Value)).Prepend(new PostChoice(entry.Keyword, entry, null)))];

    /// <summary>All options of all posts, without duplicates.</summary>
    public static IReadOnlyList<PostOption> Options => [.. All.SelectMany(entry => entry.Post.Options).DistinctBy(option => option.Name)];

    /// <summary>The entry with this name, case-insensitive.</summary>
    /// <exception cref="KeyNotFoundException">There is none.</exception>
    public static PostEntry Find(string name) =>
        All.FirstOrDefault(entry => entry.Post.Name.Equals(name, StringComparison.OrdinalIgnoreCase)) ?? throw new KeyNotFoundException($"There is no post '{name}'.");

    /// <summary>What the controllers of a family run: the entry that is written from a motion program of this style; null where the family has none.</summary>
    public static PostEntry? ForMotion(IControllerFamily family, MotionStyle style) => All.FirstOrDefault(entry => entry.Controller == family.Key && entry.Post.Motion == style);

    /// <summary>The first entry with this file extension; null if there is none.</summary>
    public static PostEntry? ForExtension(string ending) => All.FirstOrDefault(entry => entry.Post.FileExtension == ending);

    /// <summary>Extensions of the files that can be read back.</summary>
    public static IReadOnlyList<string> ReadableExtensions => [.. All.Where(entry => entry.Reader is not null).Select(entry => entry.Post.FileExtension).Distinct()];

    /// <summary>The text of docs/posts.md.</summary>
    public static string ToMarkdown()
    {
        var page = new StringBuilder("# Posts\n\nThis page is generated from the program's own table (`./test --update-golden`).\n\n");
        page.Append("| Target | Writes | File | Written from | Options | `verify` | [Operations](operations.md#programs) |\n|---|---|---|---|---|---|---|\n");
        foreach (var (post, _, reader) in All)
        {
            var options = string.Join(", ", post.Options.Select(option => $"`--{option.Name} {option.Argument}`"));
            page.Append("| ").AppendJoin(" | ", $"`{post.Name}`", post.Summary, $"`{post.FileExtension}`", post.Geometry switch { PostGeometry.Program => $"motion program, {post.Motion}", PostGeometry.Curves => "path in mm", _ => "lines and arcs in mm" }, options, reader is null ? "no" : "yes", post.OperationsRefusal is null ? "yes" : "no").Append(" |\n");
        }

        page.Append("\n| Option | Meaning | Value | Default | Of |\n|---|---|---|---|---|\n");
        foreach (var option in Options) page.Append("| ").AppendJoin(" | ", $"`--{option.Name}`", option.Summary, option.Form.Replace("|", "\\|", StringComparison.Ordinal), option.Default, string.Join(", ", TargetsWith(option))).Append(" |\n");
        return page.ToString();
    }

    /// <summary>The names of the posts that have an option.</summary>
    public static IEnumerable<string> TargetsWith(PostOption option) => All.Where(entry => entry.Post.Options.Any(one => one.Name == option.Name)).Select(entry => entry.Post.Name);
}
