using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Verification;

namespace Engraver.Core.Tests.Posts;

/// <summary>Keeps what a reader tells: the lines and arcs that are cut, and every place.</summary>
internal sealed class TellingJudge : ITraceJudge
{
    public List<Segment> Cuts { get; } = [];

    public List<TraceSample> Places { get; } = [];

    public FeedJudge Feeds { get; } = new(600.0, null);

    public BlendJudge Blends { get; } = new();

    public void Add(in TraceSample sample) => Places.Add(sample);

    public void Add(in TraceSpan span) => Cuts.Add(span.Path);

    public TraceVerdict Verdict() => throw new NotSupportedException();

    /// <summary>Reads a text, on the machine that stands at 0,0.</summary>
    /// <returns>The ids of what was found, with their lines, and what was told.</returns>
    public static async Task<(string Findings, TellingJudge Told)> ReadAsync(IProgramReader reader, string text, MachineProfile? machine = null)
    {
        var told = new TellingJudge();
        var request = new ReplayRequest(machine ?? MachineProfile.Default, default, TimeSpan.Zero, TimeSpan.MaxValue, [told]) { Feeds = told.Feeds, Blends = told.Blends };
        var found = await reader.ReplayAsync(new StringReader(text), request, progress: null, CancellationToken.None);
        return (string.Join(' ', found.Select(finding => $"{finding.Id}@{finding.Source.Line}")), told);
    }
}
