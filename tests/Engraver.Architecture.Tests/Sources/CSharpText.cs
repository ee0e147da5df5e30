using System.Text;

namespace Engraver.Architecture.Tests.Sources;

/// <summary>C# source divided into code, with every comment, string and character blanked, and comments, with everything else blanked. Both keep the length and
/// the line ends of the source.</summary>
public sealed record CSharpText(string Code, string Comments)
{
    public static CSharpText Parse(string source)
    {
        var scanner = new Scanner(source);
        scanner.ScanCode(insideInterpolation: false);
        return new CSharpText(scanner.Code.ToString(), scanner.Comments.ToString());
    }

    private enum Kind { Code, Comment, Text }

    private sealed class Scanner(string source)
    {
        private int _position;

        public StringBuilder Code { get; } = new(source.Length);
        public StringBuilder Comments { get; } = new(source.Length);

        /// <summary>Reads code to the end of the source, or to the brace that closes the hole of an interpolated string.</summary>
        public void ScanCode(bool insideInterpolation)
        {
            var depth = 0;
            while (_position < source.Length)
            {
                if (insideInterpolation && depth == 0 && source[_position] == '}') return;
                if (At("//")) Take(Kind.Comment, IndexOrEnd(source.IndexOf('\n', _position)));
                else if (At("/*")) Take(Kind.Comment, AfterOrEnd("*/", _position + 2));
                else if (StringStart() is { } start) ScanString(start);
                else if (source[_position] == '\'' && CharacterEnd() is { } end) Take(Kind.Text, end);
                else
                {
                    if (source[_position] == '{') depth++;
                    if (source[_position] == '}') depth--;
                    Take(Kind.Code, _position + 1);
                }
            }
        }

        private (int Dollars, bool Verbatim, int Quotes)? StringStart()
        {
            var at = _position;
            while (at < source.Length && source[at] is '$' or '@') at++;
            if (at >= source.Length || source[at] != '"') return null;
            var prefix = source[_position..at];
            var quotes = source.AsSpan(at).IndexOfAnyExcept('"');
            return (prefix.Count(c => c == '$'), prefix.Contains('@'), quotes < 0 ? source.Length - at : quotes);
        }

        private void ScanString((int Dollars, bool Verbatim, int Quotes) start)
        {
            var raw = start.Quotes >= 3 && !start.Verbatim;
            var close = raw ? new string('"', start.Quotes) : "\"";
            while (source[_position] != '"') Take(Kind.Text, _position + 1);
            Take(Kind.Text, _position + close.Length);
            while (_position < source.Length && !At(close))
            {
                if (!raw && start.Verbatim && At("\"\"")) Take(Kind.Text, _position + 2);
                else if (!raw && !start.Verbatim && source[_position] == '\\') Take(Kind.Text, _position + 2);
                else if (start.Dollars > 0 && source[_position] == '{') ScanHole(raw ? start.Dollars : 1);
                else Take(Kind.Text, _position + 1);
                if (!raw && start.Verbatim && At("\"\"")) Take(Kind.Text, _position + 2);
            }

            Take(Kind.Text, _position + close.Length);
        }

        /// <summary>A hole starts with as many braces as the string has dollars; twice as many are braces of the text.</summary>
        private void ScanHole(int braces)
        {
            if (At(new string('{', 2 * braces)) || !At(new string('{', braces)))
            {
                Take(Kind.Text, _position + (At(new string('{', 2 * braces)) ? 2 * braces : 1));
                return;
            }

            Take(Kind.Text, _position + braces);
            ScanCode(insideInterpolation: true);
            Take(Kind.Text, _position + braces);
        }

        /// <summary>The end of a character literal; null if the apostrophe has another meaning.</summary>
        private int? CharacterEnd()
        {
            var end = _position + 1 < source.Length && source[_position + 1] == '\\' ? source.IndexOf('\'', _position + 3 > source.Length ? source.Length : _position + 3) : _position + 2;
            return end > _position && end < source.Length && end - _position <= 12 && source[end] == '\'' ? end + 1 : null;
        }

        private bool At(string text) => string.CompareOrdinal(source, _position, text, 0, text.Length) == 0;

        private int IndexOrEnd(int index) => index < 0 ? source.Length : index;

        private int AfterOrEnd(string text, int from) => source.IndexOf(text, Math.Min(from, source.Length), StringComparison.Ordinal) is >= 0 and var at ? at + text.Length : source.Length;

        private void Take(Kind kind, int end)
        {
            for (; _position < Math.Min(end, source.Length); _position++)
            {
                var c = source[_position];
                var blank = c is '\n' or '\r' ? c : ' ';
                Code.Append(kind == Kind.Code ? c : blank);
                Comments.Append(kind == Kind.Comment ? c : blank);
            }
        }
    }
}
