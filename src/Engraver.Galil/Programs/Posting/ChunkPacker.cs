using System.Globalization;
using System.Text;
using Engraver.Core;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Posting;

/// <summary>Packs strokes into programs that fit the controller's memory, whole strokes where possible.</summary>
internal sealed class ChunkPacker
{
    /// <summary>With fewer lines for the job, every stroke would have to be divided.</summary>
    private const int MinRoom = 16;

    private readonly PostTemplate _form;
    private readonly DmcPostOptions _options;
    private readonly Func<int, SourceRef>? _sourceOf;
    private readonly int _room;
    private readonly List<(List<string> Lines, List<MotionStroke> Parts)> _chunks = [([], [])];
    private readonly List<Diagnostic> _diagnostics = [];

    private ChunkPacker(PostTemplate form, DmcPostOptions options, Func<int, SourceRef>? sourceOf)
    {
        _form = form;
        _options = options;
        _sourceOf = sourceOf;
        _room = options.MemoryLines - FixedLines(form);
    }

    /// <summary>The job as chunks. The memory must hold the subprograms and a few lines of the job (<see cref="MinLines"/>).</summary>
    public static PackedJob Pack(IEnumerable<MotionStroke> strokes, PostTemplate form, DmcPostOptions options, Func<int, SourceRef>? sourceOf)
    {
        var packer = new ChunkPacker(form, options, sourceOf);
        ArgumentOutOfRangeException.ThrowIfLessThan(packer._room, MinRoom, nameof(options));
        foreach (var stroke in strokes) packer.Add(stroke);
        return packer.Finish();
    }

    /// <summary>The findings of <see cref="Pack"/>. Strokes that certainly fit are not written, only those that may not fit.</summary>
    public static IReadOnlyList<Diagnostic> Findings(IEnumerable<MotionStroke> strokes, PostTemplate form, DmcPostOptions options, Func<int, SourceRef>? sourceOf)
    {
        var packer = new ChunkPacker(form, options, sourceOf);
        foreach (var stroke in strokes.Where(stroke => form.MaxLines(stroke) > packer._room))
        {
            packer.Add(stroke);
            packer._chunks.Clear();
            packer._chunks.Add(([], []));
        }

        return packer._diagnostics;
    }

    /// <summary>The smallest memory for which a job of this form can be packed, lines.</summary>
    public static int MinLines(PostTemplate form) => FixedLines(form) + MinRoom;

    private static int FixedLines(PostTemplate form)
    {
        const int CommentLine = 1;
        return form.Opening(0, null).Count + form.Closing.Count + CommentLine;
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
            _sourceOf?.Invoke(entity) ?? default, NumberText.Whole(rest.Index), NumberText.Whole(_options.MemoryLines), NumberText.Whole(rest.Start.X), NumberText.Whole(rest.Start.Y)));
    }

    private PackedJob Finish()
    {
        var done = 0;
        var chunks = new List<ProgramChunk>();
        foreach (var (job, parts) in _chunks)
        {
            var text = new StringBuilder();
            if (_chunks.Count > 1) text.Append(CultureInfo.InvariantCulture, $"'CHUNK {chunks.Count + 1} OF {_chunks.Count}\n");
            foreach (var line in _form.Opening(done, parts.Count > 0 ? parts[0].Terms : null).Concat(job).Concat(_form.Closing)) text.Append(line).Append('\n');
            chunks.Add(new ProgramChunk(text.ToString(), parts));
            done += job.Count;
        }

        return new PackedJob(chunks, _diagnostics);
    }

    private static int SegmentsOf(MotionStroke stroke) => stroke.SegmentCount;
}
