using System.Text;
using System.Text.Json;
using Engraver.Core.Languages;

namespace Engraver.Core.Diagnostics;

/// <summary>The fields of a JSON file, as paths (<c>homing[0].by</c>), each with its line: for files that users write.</summary>
public sealed class JsonFields
{
    private static readonly JsonReaderOptions s_options = new() { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip };

    private static readonly char[] s_ends = ['.', '['];

    private readonly List<JsonField> _fields = [];

    private JsonFields()
    {
    }

    /// <summary>The fields up to the end, or up to the point where the text is no longer JSON.</summary>
    public static JsonFields Read(string json)
    {
        var fields = new JsonFields();
        try
        {
            fields.Walk(Encoding.UTF8.GetBytes(json));
        }
        catch (Exception broken) when (broken is JsonException or InvalidOperationException)
        {
            return fields; // text that is not JSON, or a name that is not a text, is reported by the code that reads the values
        }

        return fields;
    }

    /// <summary>Each field that is not allowed where it is.</summary>
    /// <param name="known">The names that are allowed in the field with a path, empty for the file itself; null where any name is allowed.</param>
    public IEnumerable<JsonField> Unknown(Func<string, IReadOnlyList<string>?> known)
    {
        ArgumentNullException.ThrowIfNull(known);
        return _fields.Where(field => known(field.Owner) is { } names && !names.Contains(field.Name));
    }

    /// <summary>The name that was probably meant, as the end of a sentence.</summary>
    public static string Nearest(string name, IReadOnlyList<string> known) => NearestWord.Find(name, known) is { } nearest ? Wording.Get("JsonFields.Nearest", nearest) : Wording.Get("JsonFields.NoSimilarName");

    /// <summary>The first field with a path; null when there is none.</summary>
    public JsonField? Find(string path) => _fields.Where(field => field.Path == path).Select(field => (JsonField?)field).FirstOrDefault();

    /// <summary>Whether the field with a path has any content.</summary>
    public bool HasAny(string path) => _fields.Any(field => field.Owner == path);

    /// <summary>The line of a field, or of the field that contains it; of an entry of a list, that of its first field. 0 when none is in the file.</summary>
    /// <param name="setting">The name in findings: <c>homing.X.by</c> is located at <c>homing</c>.</param>
    public long LineOf(string setting)
    {
        ArgumentNullException.ThrowIfNull(setting);
        for (var path = setting; ; path = path[..path.LastIndexOfAny(s_ends)])
        {
            if (_fields.FirstOrDefault(field => field.Path == path) is { Line: > 0 } found) return found.Line;
            if (_fields.FirstOrDefault(field => field.Owner == path) is { Line: > 0 } first && path.EndsWith(']')) return first.Line;
            if (path.LastIndexOfAny(s_ends) < 0) return 0;
        }
    }

    private void Walk(ReadOnlySpan<byte> json)
    {
        var reader = new Utf8JsonReader(json, s_options);
        var (line, seen) = (1L, 0);
        var owners = new Stack<(string Path, int Next)>(); // Next: the next index in a list, -1 for an object
        var name = "";
        while (reader.Read())
        {
            var at = (int)reader.TokenStartIndex;
            line += json[seen..at].Count((byte)'\n');
            seen = at;
            switch (reader.TokenType)
            {
                case JsonTokenType.PropertyName:
                    var field = new JsonField(owners.Peek().Path, reader.GetString()!, line);
                    _fields.Add(field);
                    name = field.Path;
                    break;
                case JsonTokenType.String when _fields is [.., var named] && named.Path == name && named.Text is null:
                    _fields[^1] = named with { Text = reader.GetString() };
                    break;
                case JsonTokenType.StartObject or JsonTokenType.StartArray:
                    owners.Push((NextOr(owners, name), reader.TokenType == JsonTokenType.StartArray ? 0 : -1));
                    break;
                case JsonTokenType.EndObject or JsonTokenType.EndArray:
                    owners.Pop();
                    break;
            }
        }
    }

    /// <summary>The path of the value that begins here: the entry of the list around it, or the field that was named last.</summary>
    private static string NextOr(Stack<(string Path, int Next)> owners, string name)
    {
        if (owners.Count == 0) return "";
        if (owners.Peek().Next < 0) return name;
        var (path, entry) = owners.Pop();
        owners.Push((path, entry + 1));
        return $"{path}[{entry}]";
    }
}
