using Engraver.Core;
using Engraver.Core.Drawings;
using Engraver.Core.Operations;
using Engraver.Core.Posts;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Documents;

/// <summary>The program of one section of a job, in a format of which a program can neither change the tool nor stop for the operator.</summary>
/// <param name="Tool">The tool that has to be in the machine.</param>
/// <param name="Section">Number of its section in the job, from 1, where the tool comes several times; null where it comes once.</param>
/// <param name="Posted">The program, or why there is none.</param>
public sealed record ToolProgram(CuttingTool Tool, int? Section, PostedProgram Posted)
{
    /// <summary>The programs of a job that needs several tools or stops between repeats, in the order in which they are run. Each begins at the start point,
    /// and is ordered as the job of its tool alone.</summary>
    /// <param name="options">All options of the post by name.</param>
    /// <returns>Empty for a job of one section, and for a format whose programs change the tool and stop.</returns>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    public static IReadOnlyList<ToolProgram> Of(Drawing drawing, DrawingSettings settings, IPost post, IReadOnlyDictionary<string, string> options, PlateValues? values)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(post);
        if (post.Motion is not { } style || settings.Operations is null) return [];
        var sections = SectionJob.SectionsOf(drawing, settings, values);
        if (sections.Count < 2) return [];
        var jobs = sections.Select(section => section.Tool.Number).Distinct().ToDictionary(tool => tool, tool => JobPreparation.Prepare(drawing, settings with { Tool = tool }, style, values));
        return [.. sections.Select((section, index) =>
        {
            var isOnly = sections.Count(other => other.Tool.Number == section.Tool.Number) == 1;
            return new ToolProgram(section.Tool, isOnly ? null : index + 1, PostedProgram.FromJob(SectionJob.Within(jobs[section.Tool.Number], section), post, options));
        })];
    }

    /// <summary>The name of its file: that of the job with the tool, and with the section where the tool comes several times.</summary>
    public string FileOf(string path)
    {
        var name = $"{Path.GetFileNameWithoutExtension(path)}-T{NumberText.Whole(Tool.Number)}{(Section is { } number ? "-" + NumberText.Whole(number) : "")}{Path.GetExtension(path)}";
        return Path.Combine(Path.GetDirectoryName(path) ?? "", name);
    }
}
