using System.Reflection;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;
using System.Text.RegularExpressions;
using Engraver.TestKit;

namespace Engraver.Architecture.Tests.Structure;

/// <summary>What the compiler made of a project of src/, read as a file; nothing of it is loaded.</summary>
public sealed class BuiltAssembly : IDisposable
{
    private readonly PEReader _file;
    private readonly MetadataReader _metadata;

    private BuiltAssembly(string path)
    {
        _file = new PEReader(File.OpenRead(path));
        _metadata = _file.GetMetadataReader();
    }

    public IEnumerable<string> References => _metadata.AssemblyReferences.Select(handle => _metadata.GetString(_metadata.GetAssemblyReference(handle).Name));

    /// <summary>Static fields that can be assigned again, those behind static properties included. What the compiler or a source generator made for itself
    /// is left out.</summary>
    public IEnumerable<string> MutableStatics =>
        from handle in _metadata.TypeDefinitions
        let type = _metadata.GetTypeDefinition(handle)
        where WithOuterTypes(type).All(IsWritten) && _metadata.GetString(WithOuterTypes(type).Last().Namespace).StartsWith("Engraver.", StringComparison.Ordinal)
        from fieldHandle in type.GetFields()
        let state = _metadata.GetFieldDefinition(fieldHandle)
        where state.Attributes.HasFlag(FieldAttributes.Static) && (state.Attributes & (FieldAttributes.InitOnly | FieldAttributes.Literal)) == 0
        let name = _metadata.GetString(state.Name)
        where !IsGenerated(state.GetCustomAttributes()) || name.EndsWith("k__BackingField", StringComparison.Ordinal)
        where !name.StartsWith('!')
        select $"{_metadata.GetString(type.Name)}.{name}";

    /// <summary>Built beside these tests, in the same configuration; null when the project is not built on this system.</summary>
    public static BuiltAssembly? Open(string project)
    {
        var here = new DirectoryInfo(AppContext.BaseDirectory.TrimEnd(Path.DirectorySeparatorChar));
        var text = File.ReadAllText(Path.Combine(RepositoryFolder.Root, "src", project, project + ".csproj"));
        var name = Regex.Match(text, "<AssemblyName>(.+?)</AssemblyName>") is { Success: true } given ? given.Groups[1].Value : project;
        var path = Path.Combine(here.Parent!.Parent!.FullName, project, here.Name, name + ".dll");
        return File.Exists(path) ? new BuiltAssembly(path) : null;
    }

    public static BuiltAssembly FromFile(string path) => new(path);

    public void Dispose() => _file.Dispose();

    /// <summary>A nested type has no namespace of its own: the outermost, last here, has.</summary>
    private IEnumerable<TypeDefinition> WithOuterTypes(TypeDefinition type)
    {
        yield return type;
        while (!type.GetDeclaringType().IsNil)
        {
            type = _metadata.GetTypeDefinition(type.GetDeclaringType());
            yield return type;
        }
    }

    /// <summary>By somebody, and not by the compiler or a source generator.</summary>
    private bool IsWritten(TypeDefinition type) => !_metadata.GetString(type.Name).Contains('<') && !IsGenerated(type.GetCustomAttributes());

    private bool IsGenerated(CustomAttributeHandleCollection attributes) =>
        attributes.Select(handle => AttributeName(_metadata.GetCustomAttribute(handle).Constructor)).Any(name => name is "CompilerGeneratedAttribute" or "GeneratedCodeAttribute");

    private string AttributeName(EntityHandle constructor) => constructor.Kind switch
    {
        HandleKind.MemberReference when _metadata.GetMemberReference((MemberReferenceHandle)constructor).Parent is { Kind: HandleKind.TypeReference } parent =>
            _metadata.GetString(_metadata.GetTypeReference((TypeReferenceHandle)parent).Name),
        HandleKind.MethodDefinition => _metadata.GetString(_metadata.GetTypeDefinition(_metadata.GetMethodDefinition((MethodDefinitionHandle)constructor).GetDeclaringType()).Name),
        _ => "",
    };
}
