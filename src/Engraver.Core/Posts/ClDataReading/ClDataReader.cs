using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts.ClDataReading;

/// <summary>Reads CL data back, pair by pair, and follows its entities in their order like a tool; shares no code with the post or with the drawing
/// reader.</summary>
/// <remarks>The tool is on for the layers of cuts and off for the layer of rapids; any other layer or type of entity is a finding. Only one entity is in memory
/// at a time.</remarks>
public sealed class ClDataReader : IProgramReader
{
    public bool ReportsHeights => false;

    public Task<IReadOnlyList<Diagnostic>> ReplayAsync(TextReader text, ReplayRequest request, IProgress<ReplayProgress>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(request);
        var fault = new ClDataReplay(request, cancellation).Run(new ProgramRows(text));
        return Task.FromResult<IReadOnlyList<Diagnostic>>(fault is null ? [] : [fault]);
    }

    private sealed class ClDataReplay(ReplayRequest request, CancellationToken cancellation)
    {
        private ClDataEntity? _entity;
        private string _section = "";
        private bool _isNamed = true;
        private bool _hasCut;
        private bool _hasEntities;
        private double _seconds;
        private Point2D? _place;

        public Diagnostic? Run(ProgramRows lines)
        {
            while (lines.Next() is { } first)
            {
                cancellation.ThrowIfCancellationRequested();
                var line = lines.Number + 1;
                if (!int.TryParse(first.Trim(), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var code)) return Fault(line - 1, Wording.Get("ClDataReader.GroupCodeNotValid", Shown(first)));
                if (lines.Next() is not { } value) return Fault(line - 1, Wording.Get("ClDataReader.EndMissing"));
                if (code == 0 && value.Trim() == "EOF") return End(line);
                if ((code == 0 ? Begin(value.Trim(), line) : Take(code, value, line)) is { } fault) return fault;
            }

            return lines.Number == 0 ? VerificationRules.ProgramEmpty.At(default) : Fault(lines.Number, Wording.Get("ClDataReader.EndMissing"));
        }

        private Diagnostic? End(int line)
        {
            if (_section.Length > 0) return Fault(line, Wording.Get("ClDataReader.EndMissing"));
            return _hasEntities && _hasCut ? null : VerificationRules.ProgramEmpty.At(default);
        }

        private Diagnostic? Begin(string type, int line)
        {
            if (Finish() is { } fault) return fault;
            if (type == "SECTION" && _section.Length > 0) return Fault(line, Wording.Get("ClDataReader.EndMissing"));
            if (type == "SECTION") (_section, _isNamed) = ("?", false);
            else if (type == "ENDSEC") _section = "";
            else if (_section == "ENTITIES" && type is not ("LINE" or "ARC" or "CIRCLE" or "ELLIPSE" or "SPLINE")) return Fault(line, Wording.Get("ClDataReader.EntityNotAllowed", Shown(type)));
            else if (_section == "ENTITIES") _entity = new ClDataEntity(type, line);
            return null;
        }

        private Diagnostic? Take(int code, string value, int line)
        {
            if (!_isNamed)
            {
                if (code != 2) return Fault(line, Wording.Get("ClDataReader.GroupCodeNotValid", code));
                (_section, _isNamed) = (value.Trim(), true);
                _hasEntities |= _section == "ENTITIES";
            }
            else
            {
                _entity?.Add(code, value);
            }

            return null;
        }

        /// <summary>Runs the entity that is complete.</summary>
        private Diagnostic? Finish()
        {
            if (_entity is not { } entity) return null;
            _entity = null;
            if (entity.Layer is not ("CUT_CLOSED" or "CUT_OPEN" or "RAPID")) return Fault(entity.Line, Wording.Get("ClDataReader.LayerNotAllowed", Shown(entity.Layer)));
            if (entity.Path(out var reason) is not { } path) return Fault(entity.Line, reason);
            if (entity.Height is { } height) request.Requirements?.AddDifference(entity.Line, $"z {Shown(height)}", "z 0");
            var isCut = entity.Layer != "RAPID";
            foreach (var segment in path)
            {
                if (isCut) Join(segment.Start, entity.Line);
                AddSpan(segment, isCut);
            }

            _hasCut |= isCut;
            return null;
        }

        /// <summary>Reports a cut that does not start at the end of the previous move: the data does not state what the tool does between them.</summary>
        private void Join(Point2D start, int line)
        {
            if (_place is not { } place || place.DistanceTo(start) <= request.LongestJump) return;
            request.Requirements?.AddDifference(line, Wording.Get("ClDataReader.CutFrom", FactText.Of(start.X), FactText.Of(start.Y)), Wording.Get("ClDataReader.CutFromEndOfMove", FactText.Of(place.X), FactText.Of(place.Y)));
            foreach (var judge in request.Judges) judge.Add(new TraceSample(_seconds += 1.0, start.X, start.Y, Cutting: false));
        }

        private void AddSpan(in Segment path, bool isCut)
        {
            (_seconds, _place) = (_seconds + 1.0, path.End);
            foreach (var judge in request.Judges)
            {
                if (!isCut) judge.Add(new TraceSample(_seconds, path.End.X, path.End.Y, Cutting: false));
                else if (path.Length > 0.0) judge.Add(new TraceSpan(_seconds, _seconds + 1.0, 2, path, Cutting: true));
            }
        }

        private static string Shown(string words) => words.Length <= 40 ? words : words[..40];

        private static Diagnostic Fault(int line, string reason) => PostRules.BlockUnreadable.At(new SourceRef(line), line.ToString(CultureInfo.InvariantCulture), reason);
    }
}
