using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Core.Verification;

namespace Engraver.Core.Tests.Posts;

/// <summary>Records the output of a reader: the cut lines and arcs, and every point.</summary>
internal sealed class RecordingJudge : ITraceJudge
{
    public List<Segment> Cuts { get; } = [];

    public List<TraceSample> Places { get; } = [];

    public FeedJudge Feeds { get; } = new(600.0, null);

    public BlendJudge Blends { get; } = new();

    public void Add(in TraceSample sample) => Places.Add(sample);

    public void Add(in TraceSpan span) => Cuts.Add(span.Path);

    public TraceVerdict Verdict() => throw new NotSupportedException();

    /// <summary>Reads a text for a machine that is at 0,0.</summary>
    /// <returns>The ids of the findings, with their lines, and the recorded output.</returns>
    public static async Task<(string Findings, RecordingJudge Told)> ReadAsync(IProgramReader reader, string text, MachineProfile? machine = null)
    {
        var told = new RecordingJudge();
        var request = new ReplayRequest(machine ?? MachineProfile.Default, default, TimeSpan.Zero, TimeSpan.MaxValue, [told]) { Feeds = told.Feeds, Blends = told.Blends };
        var found = await reader.ReplayAsync(new StringReader(text), request, progress: null, CancellationToken.None);
        return (string.Join(' ', found.Select(finding => $"{finding.Id}@{finding.Source.Line}")), told);
    }
}
