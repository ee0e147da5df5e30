using System.Text;
using System.Text.Json;
using System.Text.Json.Serialization.Metadata;
using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;

namespace Engraver.Core.Machines.Profiles;

/// <summary>The fields that a profile file has, as paths (<c>homing[0].by</c>), each with its line.</summary>
internal sealed class ProfileFields
{
    private static readonly JsonReaderOptions s_options = new() { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip };

    private readonly List<Field> _fields = [];

    private ProfileFields()
    {
    }

    /// <summary>The fields up to the end, or up to where the text is no JSON any more.</summary>
    public static ProfileFields Read(string json)
    {
        var fields = new ProfileFields();
        try
        {
            fields.Walk(Encoding.UTF8.GetBytes(json));
        }
        catch (Exception broken) when (broken is JsonException or InvalidOperationException)
        {
            return fields; // where the text is no JSON, or a name no text, is told by who takes the values out of it
        }

        return fields;
    }

    /// <summary>One finding for each field that no profile has, with its line and the name that was probably meant.</summary>
    public IEnumerable<Diagnostic> Unknown()
    {
        foreach (var field in _fields)
        {
            if (Known(field.Owner) is { } names && !names.Contains(field.Name)) yield return MotionRules.ProfileFieldUnknown.At(new SourceRef(field.Line), field.Path, Nearest(field.Name, names));
        }
    }

    /// <summary>The line of a field, or of the one that it belongs to; 0 when neither stands in the file.</summary>
    /// <param name="setting">As findings name it: <c>homing.X.by</c> is told at <c>homing</c>.</param>
    public long LineOf(string setting)
    {
        for (var path = setting; ; path = path[..path.LastIndexOf('.')])
        {
            if (_fields.FirstOrDefault(field => field.Path == path) is { Line: > 0 } found) return found.Line;
            if (!path.Contains('.', StringComparison.Ordinal)) return 0;
        }
    }

    private static string Nearest(string name, List<string> known) => NearestWord.Find(name, known) is { } nearest ? Wording.Get("ProfileFields.Nearest", nearest) : Wording.Get("ProfileFields.NoneNear");

    /// <summary>The names that may stand in a field; null where any may: the numbers of inputs and outputs, and inside a field that is told as unknown, or as no value, itself.</summary>
    private static List<string>? Known(string owner) => owner switch
    {
        "" => Names(MachineProfileJson.Default.MachineProfileDocument),
        "travelX" or "travelY" or "travelZ" => Names(MachineProfileJson.Default.TravelDocument),
        _ when owner.StartsWith("homing[", StringComparison.Ordinal) && owner.EndsWith(']') => Names(MachineProfileJson.Default.HomingDocument),
        _ => null,
    };

    private static List<string> Names(JsonTypeInfo type) => [.. type.Properties.Select(property => property.Name)];

    private void Walk(ReadOnlySpan<byte> json)
    {
        var reader = new Utf8JsonReader(json, s_options);
        var (line, seen) = (1L, 0);
        var owners = new Stack<(string Path, int Entry)>(); // Entry: the next one of a list, -1 for an object
        var name = "";
        while (reader.Read())
        {
            var at = (int)reader.TokenStartIndex;
            line += json[seen..at].Count((byte)'\n');
            seen = at;
            switch (reader.TokenType)
            {
                case JsonTokenType.PropertyName:
                    var field = new Field(owners.Peek().Path, reader.GetString()!, line);
                    _fields.Add(field);
                    name = field.Path;
                    break;
                case JsonTokenType.StartObject or JsonTokenType.StartArray:
                    owners.Push((EntryOr(owners, name), reader.TokenType == JsonTokenType.StartArray ? 0 : -1));
                    break;
                case JsonTokenType.EndObject or JsonTokenType.EndArray:
                    owners.Pop();
                    break;
            }
        }
    }

    /// <summary>The path of what begins here: the entry of the list around it, or the field that was named last.</summary>
    private static string EntryOr(Stack<(string Path, int Entry)> owners, string name)
    {
        if (owners.Count == 0) return "";
        if (owners.Peek().Entry < 0) return name;
        var (path, entry) = owners.Pop();
        owners.Push((path, entry + 1));
        return $"{path}[{entry}]";
    }

    /// <param name="Owner">Path of what it stands in; empty for the profile itself.</param>
    private readonly record struct Field(string Owner, string Name, long Line)
    {
        public string Path => Owner.Length == 0 ? Name : $"{Owner}.{Name}";
    }
}
