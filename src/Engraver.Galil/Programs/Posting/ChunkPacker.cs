using System.Globalization;
using System.Text;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Packs strokes into programs that fit the controller's memory, whole strokes where possible.</summary>
internal sealed class ChunkPacker
{
    /// <summary>With fewer lines for the job, every stroke would have to be divided.</summary>
    private const int LeastRoom = 16;

    private readonly PostForm _form;
    private readonly DmcPostOptions _options;
    private readonly Func<int, SourceRef>? _sourceOf;
    private readonly int _room;
    private readonly List<(List<string> Lines, List<MotionStroke> Parts)> _chunks = [([], [])];
    private readonly List<Diagnostic> _diagnostics = [];

    private ChunkPacker(PostForm form, DmcPostOptions options, Func<int, SourceRef>? sourceOf)
    {
        _form = form;
        _options = options;
        _sourceOf = sourceOf;
        _room = options.MemoryLines - FixedLines(form);
    }

    /// <summary>The job as chunks. The memory must hold the subprograms and a few lines of the job (<see cref="FewestLines"/>).</summary>
    public static PackedJob Pack(IEnumerable<MotionStroke> strokes, PostForm form, DmcPostOptions options, Func<int, SourceRef>? sourceOf)
    {
        var packer = new ChunkPacker(form, options, sourceOf);
        ArgumentOutOfRangeException.ThrowIfLessThan(packer._room, LeastRoom, nameof(options));
        foreach (var stroke in strokes) packer.Add(stroke);
        return packer.Finish();
    }

    /// <summary>The findings of <see cref="Pack"/>. Strokes that certainly fit are not written, only those that may not fit.</summary>
    public static IReadOnlyList<Diagnostic> Findings(IEnumerable<MotionStroke> strokes, PostForm form, DmcPostOptions options, Func<int, SourceRef>? sourceOf)
    {
        var packer = new ChunkPacker(form, options, sourceOf);
        foreach (var stroke in strokes.Where(stroke => form.MostLines(stroke) > packer._room))
        {
            packer.Add(stroke);
            packer._chunks.Clear();
            packer._chunks.Add(([], []));
        }

        return packer._diagnostics;
    }

    /// <summary>The smallest memory for which a job of this form can be packed, lines.</summary>
    public static int FewestLines(PostForm form) => FixedLines(form) + LeastRoom;

    private static int FixedLines(PostForm form)
    {
        const int CommentLine = 1;
        return form.Opening(0).Count + form.Closing.Count + CommentLine;
    }

    private void Add(MotionStroke stroke)
    {
        var rest = stroke;
        IReadOnlyList<string> lines;
        while (!FitsAChunk(rest, out lines))
        {
            (var first, rest) = LargestPart(rest);
            Put(_form.Stroke(first), first);
            Report(rest);
        }

        Put(lines, rest);
    }

    private bool FitsAChunk(MotionStroke part, out IReadOnlyList<string> lines)
    {
        lines = SegmentsOf(part) > _room * DmcLimits.LineLength ? [] : _form.Stroke(part);
        return lines.Count > 0 && lines.Count <= _room;
    }

    /// <summary>The longest first part of the stroke that fits a chunk, searched from above by proportion.</summary>
    private (MotionStroke First, MotionStroke Tail) LargestPart(MotionStroke stroke)
    {
        const double Shrink = 0.97;
        var segments = Math.Min(SegmentsOf(stroke) - 1, _room * 8);
        while (true)
        {
            var parts = StrokeCut.Before(stroke, segments);
            var lines = _form.Stroke(parts.First).Count;
            if (lines <= _room) return parts;
            segments = Math.Max(1, (int)(SegmentsOf(parts.First) * Shrink * _room / lines));
        }
    }

    private void Put(IReadOnlyList<string> lines, MotionStroke part)
    {
        if (_chunks[^1].Lines.Count + lines.Count > _room) _chunks.Add(([], []));
        _chunks[^1].Lines.AddRange(lines);
        _chunks[^1].Parts.Add(part);
    }

    private void Report(MotionStroke rest)
    {
        var entity = rest.Sequences[0].Segments[0].EntityIndex;
        _diagnostics.Add(MotionRules.StrokeCutByMemory.At(
            _sourceOf?.Invoke(entity) ?? default, Text(rest.Index), Text(_options.MemoryLines), Text(rest.Start.X), Text(rest.Start.Y)));
    }

    private PackedJob Finish()
    {
        var done = 0;
        var chunks = new List<ProgramChunk>();
        foreach (var (job, parts) in _chunks)
        {
            var text = new StringBuilder();
            if (_chunks.Count > 1) text.Append(CultureInfo.InvariantCulture, $"'CHUNK {chunks.Count + 1} OF {_chunks.Count}\n");
            foreach (var line in _form.Opening(done).Concat(job).Concat(_form.Closing)) text.Append(line).Append('\n');
            chunks.Add(new ProgramChunk(text.ToString(), parts));
            done += job.Count;
        }

        return new PackedJob(chunks, _diagnostics);
    }

    private static int SegmentsOf(MotionStroke stroke) => stroke.SegmentCount;

    private static string Text(long value) => value.ToString(CultureInfo.InvariantCulture);
}

/// <summary>A job as chunks that fit the controller's memory.</summary>
/// <param name="Chunks">In order of cutting.</param>
/// <param name="Diagnostics">Strokes that had to be divided to fit the memory.</param>
internal sealed record PackedJob(IReadOnlyList<ProgramChunk> Chunks, IReadOnlyList<Diagnostic> Diagnostics);

/// <summary>One program of a job that does not fit the controller's memory at once.</summary>
/// <param name="Text">Complete with its subprograms; ends with a line end (LF).</param>
/// <param name="Parts">The strokes that it cuts, in order; a stroke longer than the memory is divided into several parts, each in a separate chunk.</param>
internal sealed record ProgramChunk(string Text, IReadOnlyList<MotionStroke> Parts)
{
    /// <summary>Every segment in the order of cutting, which is the order of the VP and CR commands in the text.</summary>
    public IEnumerable<VectorSegment> Segments => Parts.SelectMany(part => part.Sequences).SelectMany(sequence => sequence.Segments);
}
