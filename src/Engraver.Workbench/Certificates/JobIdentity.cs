using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Core.Posts;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Certificates;

/// <summary>Identity of a job: hashes of the drawing's bytes, of the machine profile and of the program, and the settings themselves.</summary>
/// <param name="Drawing">SHA-256 of the drawing's file; null if the file cannot be read.</param>
/// <param name="Settings">As in <see cref="SettingValues"/>.</param>
/// <param name="Profile">SHA-256 of the profile in its full form: an omitted field equals one with the default value.</param>
/// <param name="Target">Name of the post.</param>
/// <param name="Program">SHA-256 of the program's text; computed on demand, null when there is none.</param>
public sealed record JobIdentity(string? Drawing, IReadOnlyDictionary<string, string> Settings, string Profile, string Target, Lazy<string?> Program)
{
    /// <summary>The kind of controller that the program is written for; null for the default of the target.</summary>
    public string? Dialect { get; init; }

    /// <summary>The fonts of the texts that are cut.</summary>
    public IReadOnlyList<CutFont> Fonts { get; init; } = [];

    /// <summary>Of a job that a machine runs: its program is the post of the same motion in the style of the strategy.</summary>
    /// <param name="program">Program of <paramref name="job"/> with feeds limited to the link.</param>
    /// <param name="post">What the machine's controller runs (<see cref="PostTable.ForMotion"/>).</param>
    public static JobIdentity OfRun(PreparedJob job, MotionProgram program, IPost post)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(post);
        var sent = job with { Motion = job.Motion with { Program = program } };
        return Of(job.Drawing.FileName, job.Trajectories is null ? job.Recorded : job.Settings, post.Name, () => PostedProgram.FromJob(sent, post, PostedProgram.NoOptions).Text is { } text ? ContentHash.OfText(text) : null) with { Fonts = job.Fonts };
    }

    /// <summary>Identity of a posted program.</summary>
    /// <param name="drawing">As it was read from its file.</param>
    /// <param name="program">Computes the hash of the program.</param>
    public static JobIdentity Of(Drawing drawing, DrawingSettings settings, string target, Func<string?> program)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(settings);
        return Of(drawing.FileName, settings.AsOpened(drawing), target, program) with { Fonts = JobPreparation.To<LetteredJob>(drawing, settings).Letters.Fonts };
    }

    private static JobIdentity Of(string drawing, DrawingSettings settings, string target, Func<string?> program) =>
        new JobIdentity(ContentHash.OfFile(drawing), SettingValues.Of(settings), OfProfile(settings.Machine), target, new Lazy<string?>(program));

    /// <summary>The differences: <c>drawing</c>, keys of settings, <c>profile</c>, <c>fonts</c>.</summary>
    /// <param name="fonts">Those of the record; they are compared where both cut texts.</param>
    public IReadOnlyList<string> Differences(string? drawing, IReadOnlyDictionary<string, string> settings, string? profile, IReadOnlyList<CutFont> fonts)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(fonts);
        List<string> differs = [];
        if (Drawing is null || drawing != Drawing) differs.Add("drawing");
        differs.AddRange(settings.Keys.Union(Settings.Keys).Where(key => settings.GetValueOrDefault(key) != Settings.GetValueOrDefault(key)).Order(StringComparer.Ordinal));
        if (profile != Profile) differs.Add("profile");
        if (fonts.Count > 0 && Fonts.Count > 0 && CutFont.Differences(fonts, Fonts).Count > 0) differs.Add("fonts");
        return differs;
    }

    /// <summary>The hash of a profile.</summary>
    public static string OfProfile(MachineProfile profile) => ContentHash.OfText(MachineProfileFile.Write(profile));

    /// <summary>The hash of settings.</summary>
    public static string OfSettings(IReadOnlyDictionary<string, string> settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        return ContentHash.OfText(string.Concat(settings.OrderBy(one => one.Key, StringComparer.Ordinal).Select(one => $"{one.Key}={one.Value}\n")));
    }
}
